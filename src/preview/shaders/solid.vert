// A cube reaches from `lower` to `upper`. A pyramid reaches from its base to its apex: x and y of both are the axis, and
// the half width, which a cube does not have, says how far the base reaches from it.
layout(location = 0) in vec4 lower_high; // w: half width
layout(location = 1) in vec4 lower_low;  // to be added
layout(location = 2) in vec4 upper_high; // w: height
layout(location = 3) in vec4 upper_low;  // to be added
layout(location = 4) in vec4 tint;

flat out vec3 lower; // from the eye; of a pyramid z alone, and x, y: room of its faces towards -x, +x
flat out vec3 upper; // from the eye; of a pyramid x, y: room of its faces towards -y, +y
flat out vec2 slant; // half width and height of a pyramid, 0 for a cube
flat out vec2 range; // near, end
flat out vec3 color;

// Corners of a box in an order that makes one strip of its six faces, all turned outwards. Bits: x, y, z.
const int STRIP[14] = int[](0, 1, 4, 5, 7, 1, 3, 0, 2, 4, 6, 7, 2, 3);

// How far the eye is within the two side faces along an axis, by their normals (-+height, half width): the product of
// lengths that the ray's slope against the same normal is divided into.
vec2 rooms(vec2 to_axis, vec2 to_apex, vec2 half_width, vec2 height) {
    vec2 sideways = multiply(height, to_axis);
    vec2 upwards = multiply(half_width, to_apex);
    return vec2(add(upwards, -sideways).x, add(upwards, sideways).x);
}

// A corner of the hull, from the eye: the body with a rim, so that no sample is lost to the rounding of its outline.
vec3 corner_of_hull(vec3 low, vec3 high, float half_width, float height) {
    float pixel = 2.0 * max(tan_x, tan_y) / side;
    float far_end = max(largest(low), largest(high)) + half_width;
    float rim = 0.5 * pixel * far_end + 1e-4 * (largest(high - low) + half_width);
    int corner = STRIP[gl_VertexID];
    bvec3 positive = bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
    vec3 point = mix(low - rim, high + rim, positive);
    if (half_width > 0.0) {
        // The same slope as the body's, moved outwards.
        float reach = rim * (1.0 + half_width / height) + (positive.z ? 0.0 : half_width);
        point.xy = low.xy + mix(vec2(-reach), vec2(reach), positive.xy);
    }
    return point;
}

void main() {
    vec2 x0 = from_eye(lower_high.x, lower_low.x, 0);
    vec2 y0 = from_eye(lower_high.y, lower_low.y, 1);
    vec2 z0 = from_eye(lower_high.z, lower_low.z, 2);
    vec2 x1 = from_eye(upper_high.x, upper_low.x, 0);
    vec2 y1 = from_eye(upper_high.y, upper_low.y, 1);
    vec2 z1 = from_eye(upper_high.z, upper_low.z, 2);
    vec3 low = vec3(x0.x, y0.x, z0.x);
    vec3 high = vec3(x1.x, y1.x, z1.x);
    float size = max(max(largest(low), largest(high)), max(lower_high.w, upper_high.w));
    float scale = 1.0 / power_below(size);
    vec2 half_width = vec2(lower_high.w, lower_low.w) * scale;
    vec2 height = vec2(upper_high.w, upper_low.w) * scale;

    lower = low * scale;
    upper = high * scale;
    vec3 corner = corner_of_hull(lower, upper, half_width.x, height.x);
    vec3 seen = to_camera(corner);
    gl_Position = vec4(seen.xy / vec2(tan_x, tan_y), 0.0, seen.z);

    if (half_width.x > 0.0) {
        lower.xy = rooms(x1 * scale, z1 * scale, half_width, height);
        upper.xy = rooms(y1 * scale, z1 * scale, half_width, height);
    }
    slant = vec2(half_width.x, height.x);
    range = vec2(near, end) * scale;
    color = tint.rgb;
}
