flat in vec3 color;
noperspective in float closeness;
out vec4 shown;

// How much nearer a line counts than it is: it usually lies in a surface, and shall be seen on it.
const float FAVOR = 1.005;

void main() {
    if (closeness * end < 1.0) {
        discard;
    }
    gl_FragDepth = near * closeness * FAVOR;
    shown = vec4(color, 1.0);
}
