// Where the picture is sampled, in pixels from its lower left corner.
vec2 sample_point() {
#if defined(PER_SAMPLE) && defined(GL_ARB_sample_shading)
    return floor(gl_FragCoord.xy) + gl_SamplePosition;
#else
    return gl_FragCoord.xy;
#endif
}

// The ray of this sample at depth 1: right and up in the camera's axes. Its parameter is its depth.
vec2 ray_slopes() {
    return (2.0 * sample_point() - side) / side * vec2(tan_x, tan_y);
}

// The same ray in world axes. One formula for every shader: surfaces that coincide must come out at the same depth.
vec3 ray_direction(vec2 slopes) {
    EXACT vec3 direction = (look + right * slopes.x) + up * slopes.y;
    return direction;
}

bool is_visible(float depth, float first, float last) {
    return depth > first && depth <= last;
}
