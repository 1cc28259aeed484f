flat in vec3 color;
flat in float depth;
in vec2 offset;
out vec4 shown;

void main() {
    float away = dot(offset, offset);
    if (away > 1.0) {
        discard;
    }
    gl_FragDepth = near / depth;
    // A dark rim keeps it apart from what is bright behind it.
    shown = vec4(away > 0.5 ? 0.25 * color : color, 1.0);
}
