#version 330 core
uniform sampler2D picture; // as large as the square
uniform ivec2 corner;      // lower left one of the square in the window
uniform int first;         // row of the picture in the lowest row of the square
uniform int next;          // 1 where the one above it comes next, or -1
out vec4 shown;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
    shown = texelFetch(picture, ivec2(pixel.x, first + next * pixel.y), 0);
}
