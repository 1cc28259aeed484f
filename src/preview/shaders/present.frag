#version 330 core
uniform sampler2D preview; // bottom row first
uniform sampler2D traced;  // top row first
uniform ivec2 corner;      // lower left one of the square in the window
uniform int square;        // its side in pixels
uniform int split;         // columns from here on show the traced picture
uniform bool divided;      // by a line between both
out vec4 shown;

const vec4 LINE = vec4(0.75, 0.75, 0.78, 1.0);

// The texel of a square image that covers the middle of a pixel of the square.
ivec2 texel_at(ivec2 pixel, int image_side) {
    return (2 * pixel + 1) * image_side / (2 * square);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
    if (divided && pixel.x == split) {
        shown = LINE;
    } else if (pixel.x < split) {
        shown = texelFetch(preview, texel_at(pixel, textureSize(preview, 0).x), 0);
    } else {
        ivec2 from_top = ivec2(pixel.x, square - 1 - pixel.y);
        shown = texelFetch(traced, texel_at(from_top, textureSize(traced, 0).x), 0);
    }
}
