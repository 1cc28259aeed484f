flat in vec3 lower;
flat in vec3 upper;
flat in vec2 slant;
flat in vec2 range;
flat in vec3 color;
out vec4 shown;

const float ENDLESS = 3.4e38;

// Cuts the part of the ray from span.x to span.y by the half-space depth * slope <= room. A true division, so that faces
// of different bodies in one plane come out at the same depth, bit for bit.
void cut(inout vec2 span, float room, float slope) {
    if (slope < 0.0) {
        span.x = max(span.x, room / slope);
    } else if (slope > 0.0) {
        span.y = min(span.y, room / slope);
    } else if (room < 0.0) {
        span.y = -ENDLESS;
    }
}

vec2 span_of_cube(vec3 direction) {
    vec2 span = vec2(-ENDLESS, ENDLESS);
    for (int axis = 0; axis < 3; axis++) {
        cut(span, upper[axis], direction[axis]);
        cut(span, -lower[axis], -direction[axis]);
    }
    return span;
}

vec2 span_of_pyramid(vec3 direction) {
    vec2 span = vec2(-ENDLESS, ENDLESS);
    vec2 sideways = slant.y * direction.xy;
    float upwards = slant.x * direction.z;
    cut(span, lower.x, upwards - sideways.x);
    cut(span, lower.y, upwards + sideways.x);
    cut(span, upper.x, upwards - sideways.y);
    cut(span, upper.y, upwards + sideways.y);
    cut(span, -lower.z, -direction.z);
    return span;
}

void main() {
    vec3 direction = ray_direction(ray_slopes());
    vec2 span = slant.x > 0.0 ? span_of_pyramid(direction) : span_of_cube(direction);
    float depth = span.x > range.x ? span.x : span.y;
    if (span.x > span.y || !is_visible(depth, range.x, range.y)) {
        discard;
    }
    gl_FragDepth = range.x / depth;
    shown = vec4(color, 1.0);
}
