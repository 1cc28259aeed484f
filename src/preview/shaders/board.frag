uniform vec2 height;   // of the board, as a pair
uniform vec2 phase;    // the eye's place in the pattern, in cells, each below 2
uniform float density; // cells a unit
uniform float spread;  // width of a sample, in pixels
uniform vec3 tint;
uniform bool textured;
uniform sampler2D white_image;
uniform sampler2D black_image;
out vec4 shown;

// Beyond this many cells a pixel, nothing of the pattern is left to see.
const float BLURRED = 1e6;
// Pieces into which the longer side of a sample is cut.
const int PIECES = 4;
const float PI = 3.14159265;

// Mean over a width of the square wave that is 1 in the cells 0, 2, 4, ... along one axis and -1 in the others.
float mean_of_wave(float x, float width) {
    if (width <= 1.0) {
        // At most one edge can lie within.
        float edge = floor(x + 0.5);
        float rising = 1.0 - 2.0 * mod(edge, 2.0);
        return rising * clamp(2.0 * (x - edge) / width, -1.0, 1.0);
    }
    // The wave's integral is a wave of triangles.
    vec2 ends = x + vec2(-0.5, 0.5) * width;
    vec2 integral = 1.0 - abs(mod(ends, 2.0) - 1.0);
    return (integral.y - integral.x) / width;
}

// The pattern, 1 where it is white and -1 where it is black, as a piece of a sample around `p` shows it. The piece is a
// parallelogram, and taken for a rectangle that is as wide on average.
float mean_of_piece(vec2 p, vec2 across, vec2 along) {
    vec2 width = max(sqrt(along * along + across * across), 1e-6);
    return mean_of_wave(p.x, width.x) * mean_of_wave(p.y, width.y);
}

// The same for all of a pixel that covers more than a cell, from the Fourier series of the pattern: each of its waves
// fades by its frequency in the picture, so that none too fine to be seen comes back as a coarse one that is not there,
// and the stripes stay that a board shows along its diagonals up to the horizon.
float mean_of_waves(vec2 p, vec2 across, vec2 along) {
    p = mod(p, 2.0);
    float sum = 0.0;
    for (int m = 1; m <= 3; m += 2) {
        for (int n = -3; n <= 3; n += 2) {
            vec2 wave = vec2(m, n);
            vec2 cycles = 0.5 * vec2(dot(wave, across), dot(wave, along));
            // A Gaussian of half a pixel.
            float left = exp(-0.5 * PI * PI * dot(cycles, cycles));
            sum -= left * cos(PI * dot(wave, p)) / (wave.x * wave.y);
        }
    }
    return clamp(8.0 / (PI * PI) * sum, -1.0, 1.0);
}

// Both images by their own filtered texels: the one of this cell, and of the other one what lies next to here in the
// nearest cell that has it. Row 0 of an image lies at the side of a cell with the greatest y.
vec3 color_of_images(vec2 p, vec2 across, vec2 along, float white) {
    vec2 cell = floor(p);
    vec2 here = p - cell;
    vec2 reach = abs(across) + abs(along);
    vec2 way = min(here, 1.0 - here) * reach.yx;
    vec2 step_over = vec2(here.x < 0.5 ? 1.0 : -1.0, here.y < 0.5 ? 1.0 : -1.0);
    vec2 there = here + step_over * (way.x < way.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    bool is_white = mod(cell.x + cell.y, 2.0) < 0.5;
    vec2 on_white = is_white ? here : there;
    vec2 on_black = is_white ? there : here;
    across.y = -across.y;
    along.y = -along.y;
    vec3 light = textureGrad(white_image, vec2(on_white.x, 1.0 - on_white.y), across, along).rgb;
    vec3 dark = textureGrad(black_image, vec2(on_black.x, 1.0 - on_black.y), across, along).rgb;
    return mix(dark, light, white);
}

// What a sample around `p` shows; `across` and `along` are how the place in the pattern changes from pixel to pixel. The
// longer way is cut into pieces. Those towards the ends count less, and where cells are small the ends reach into the
// neighbouring samples.
vec3 color_of_sample(vec2 p, vec2 across, vec2 along) {
    float blur = length(along);
    float fine = smoothstep(0.7, 1.4, blur);
    float waves = fine > 0.0 && blur < BLURRED ? mean_of_waves(p, across, along) : 0.0;
    if (fine == 1.0 && !textured) {
        return tint * (0.5 + 0.5 * waves);
    }
    across *= spread;
    along *= spread * (1.0 + smoothstep(0.3, 0.8, blur));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int piece = 0; piece < PIECES; piece++) {
        float place = (float(piece) + 0.5) / float(PIECES) - 0.5;
        vec2 at = p + along * place;
        vec2 part = along / float(PIECES);
        float pattern = fine < 1.0 ? mix(mean_of_piece(at, across, part), waves, fine) : waves;
        float white = 0.5 + 0.5 * pattern;
        float weight = 0.5 - abs(place);
        sum += weight * (textured ? color_of_images(at, across, part, white) : tint * white);
        weights += weight;
    }
    return sum / weights;
}

void main() {
    vec3 direction = ray_direction(ray_slopes());
    float depth = from_eye(height.x, height.y, 2).x / direction.z;
    if (!is_visible(depth, near, end)) {
        discard;
    }
    gl_FragDepth = near / depth;

    // Place in the pattern, and how it changes from pixel to pixel.
    float cells = depth * density;
    vec2 p = phase + direction.xy * cells;
    vec2 pixel = 2.0 / side * vec2(tan_x, tan_y) * cells;
    vec2 across = (right.xy - direction.xy * (right.z / direction.z)) * pixel.x;
    vec2 along = (up.xy - direction.xy * (up.z / direction.z)) * pixel.y;
    bool is_wide = dot(across, across) > dot(along, along);
    shown = vec4(is_wide ? color_of_sample(p, along, across) : color_of_sample(p, across, along), 1.0);
}
