flat in vec3 toward;
flat in vec4 ball;
flat in vec3 color;
out vec4 shown;

// Depths at which the ray meets the sphere, the nearer one first; NaN where it passes by.
//
// Everything is taken from the point of the sphere next to the eye, where the ray starts at that point's depth: small
// spheres far away and huge ones under one's feet then keep their digits alike.
vec2 crossings(vec2 slopes) {
    float gap = ball.x;
    float radius = ball.y;
    vec2 start = gap * (slopes * toward.z - toward.xy);
    float a = 1.0 + dot(slopes, slopes);
    float b = dot(start, slopes) - radius * (dot(toward.xy, slopes) + toward.z);
    float c = dot(start, start) - 2.0 * radius * dot(toward.xy, start);
    float root = sqrt(b * b - a * c);
    float q = b > 0.0 ? -b - root : -b + root;
    vec2 t = vec2(c / q, q / a);
    return gap * toward.z + vec2(min(t.x, t.y), max(t.x, t.y));
}

void main() {
    vec2 depths = crossings(ray_slopes());
    float depth = depths.x > ball.z ? depths.x : depths.y;
    if (!is_visible(depth, ball.z, ball.w)) {
        discard;
    }
    gl_FragDepth = ball.z / depth;
    shown = vec4(color, 1.0);
}
