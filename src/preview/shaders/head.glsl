#version 330 core
// Both are taken where they are there. Without the first a compiler may reorder sums whose rounding is made use of, and
// huge bodies near the eye lose digits; without the second outlines are not smooth.
#extension GL_ARB_gpu_shader5 : enable
#extension GL_ARB_sample_shading : enable
#ifdef GL_ARB_gpu_shader5
#define EXACT precise
#else
#define EXACT
#endif

layout(std140) uniform View {
    vec3 eye_high;
    float near;   // along `look`, as all depths
    vec3 eye_low; // to be added to `eye_high`
    float end;    // the far plane's depth
    vec3 look;
    float tan_x; // half extent of the picture at depth 1
    vec3 right;
    float tan_y;
    vec3 up;
    float side; // pixels
};

// World axes to the camera's: right, up, look.
vec3 to_camera(vec3 v) {
    return vec3(dot(v, right), dot(v, up), dot(v, look));
}
