layout(location = 0) in vec4 high; // position
layout(location = 1) in vec4 low;  // to be added
layout(location = 2) in vec4 tint;

uniform float radius; // pixels

flat out vec3 color;
flat out float depth;
out vec2 offset; // from the middle, 1 at the rim

void main() {
    vec3 from = vec3(
        from_eye(high.x, low.x, 0).x, from_eye(high.y, low.y, 1).x, from_eye(high.z, low.z, 2).x);
    vec3 seen = to_camera(from);
    offset = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    depth = seen.z;
    color = tint.rgb;
    // Out of sight unless between the near and the far plane.
    bool visible = depth > near && depth <= end;
    vec2 place = seen.xy / (vec2(tan_x, tan_y) * depth) + offset * (2.0 * radius / side);
    gl_Position = visible ? vec4(place, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
