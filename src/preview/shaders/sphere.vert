layout(location = 0) in vec4 high; // centre and radius
layout(location = 1) in vec4 low;  // to be added
layout(location = 2) in vec4 tint;

flat out vec3 toward; // unit, to the centre, in the camera's axes
flat out vec4 ball;   // way to the surface along it (negative inside), radius, near, end
flat out vec3 color;

// |offset|^2 - radius^2, which tells near from far and inside from outside: no digit may be lost in it.
float excess_of(vec2 x, vec2 y, vec2 z, vec2 radius) {
    vec2 squares = add(add(multiply(x, x), multiply(y, y)), multiply(z, z));
    return add(squares, -multiply(radius, radius)).x;
}

// A corner of a square that hides the sphere. Its plane is perpendicular to the way to the centre, so it holds the
// tangent cone, and clipping does the rest. Near the sphere the cone is too wide for that: all of the picture then.
vec4 corner_of_hull(float distance, float radius, float excess) {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    if (distance < 1.25 * radius) {
        return vec4(corner, 0.0, 1.0);
    }
    float pixel = 2.0 * max(tan_x, tan_y) / side;
    float reach = radius / sqrt(excess) + pixel;
    vec3 across = normalize(cross(toward, abs(toward.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 along = cross(toward, across);
    vec3 point = toward + reach * (corner.x * across + corner.y * along);
    return vec4(point.xy / vec2(tan_x, tan_y), 0.0, point.z);
}

void main() {
    vec2 x = from_eye(high.x, low.x, 0);
    vec2 y = from_eye(high.y, low.y, 1);
    vec2 z = from_eye(high.z, low.z, 2);
    float scale = 1.0 / power_below(max(high.w, largest(vec3(x.x, y.x, z.x))));
    vec2 radius = vec2(high.w, low.w) * scale;
    vec3 offset = vec3(x.x, y.x, z.x) * scale;

    float distance = length(offset);
    float excess = excess_of(x * scale, y * scale, z * scale, radius);
    // At the centre itself every direction is as good.
    toward = distance > 0.0 ? normalize(to_camera(offset)) : vec3(0.0, 0.0, 1.0);
    ball = vec4(excess / (distance + radius.x), radius.x, near * scale, end * scale);
    color = tint.rgb;
    gl_Position = corner_of_hull(distance, radius.x, excess);
}
