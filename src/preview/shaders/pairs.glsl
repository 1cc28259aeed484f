// Numbers as unevaluated sums of two floats, after T. J. Dekker, A floating-point technique for extending the available
// precision (1971): x is the number, y what rounding took from it.

vec2 sum_of(float a, float b) {
    EXACT float sum = a + b;
    EXACT float part = sum - a;
    EXACT float error = (a - (sum - part)) + (b - part);
    return vec2(sum, error);
}

vec2 halves_of(float a) {
    EXACT float scaled = 4097.0 * a;
    EXACT float high = scaled - (scaled - a);
    EXACT float low = a - high;
    return vec2(high, low);
}

vec2 product_of(float a, float b) {
    EXACT float product = a * b;
    vec2 p = halves_of(a);
    vec2 q = halves_of(b);
    EXACT float error = ((p.x * q.x - product) + p.x * q.y + p.y * q.x) + p.y * q.y;
    return vec2(product, error);
}

vec2 add(vec2 a, vec2 b) {
    vec2 sum = sum_of(a.x, b.x);
    EXACT float error = sum.y + (a.y + b.y);
    return sum_of(sum.x, error);
}

vec2 multiply(vec2 a, vec2 b) {
    vec2 product = product_of(a.x, b.x);
    EXACT float error = product.y + (a.x * b.y + a.y * b.x);
    return sum_of(product.x, error);
}

// Along one axis, from the eye to a point. The first number alone is right to its last place.
vec2 from_eye(float high, float low, int axis) {
    return add(vec2(high, low), -vec2(eye_high[axis], eye_low[axis]));
}

// The power of two at or below a positive number, by its bits: lengths divided by it keep every digit, and their
// squares neither overflow nor vanish.
float power_below(float length) {
    return intBitsToFloat(floatBitsToInt(length) & 0x7f800000);
}

float largest(vec3 v) {
    vec3 size = abs(v);
    return max(size.x, max(size.y, size.z));
}
