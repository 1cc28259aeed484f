layout(location = 0) in vec4 start_high;
layout(location = 1) in vec4 start_low;
layout(location = 2) in vec4 stop_high;
layout(location = 3) in vec4 stop_low;
layout(location = 4) in vec4 tint;

uniform float width; // pixels

flat out vec3 color;
noperspective out float closeness; // 1 / depth, which is linear in the picture

vec3 seen_from(vec4 high, vec4 low) {
    vec3 from = vec3(
        from_eye(high.x, low.x, 0).x, from_eye(high.y, low.y, 1).x, from_eye(high.z, low.z, 2).x);
    return to_camera(from);
}

// The end `a` of a segment, moved towards `b` to where it is beyond the near plane.
vec3 clipped(vec3 a, vec3 b) {
    float first = near * 1.000001;
    return a.z < first ? mix(a, b, (first - a.z) / (b.z - a.z)) : a;
}

void main() {
    vec3 start = seen_from(start_high, start_low);
    vec3 stop = seen_from(stop_high, stop_low);
    color = tint.rgb;
    closeness = 0.0;
    if (max(start.z, stop.z) <= near) {
        gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
        return;
    }
    vec3 a = clipped(start, stop);
    vec3 b = clipped(stop, start);
    vec2 half_extent = vec2(tan_x, tan_y);
    vec2 from = a.xy / (half_extent * a.z);
    vec2 to = b.xy / (half_extent * b.z);
    vec2 way = to - from;
    vec2 along = dot(way, way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
    bool is_stop = (gl_VertexID & 1) != 0;
    float hand = gl_VertexID < 2 ? -1.0 : 1.0;
    vec2 place = (is_stop ? to : from) + hand * (width / side) * vec2(-along.y, along.x);
    closeness = 1.0 / (is_stop ? b.z : a.z);
    gl_Position = vec4(place, 0.0, 1.0);
}
