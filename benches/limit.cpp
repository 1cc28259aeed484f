// How fast a small scene can be traced at all: every ray against every object, sixteen rays at a time, in single precision,
// with no more accuracy than a picture of 8 bits shows. No product: no files, at most 15 objects, rays from outside only.
//
//   limit SCENE --eye X,Y,Z --look X,Y,Z [--size N] [--threads N] [--repeats N]
//
// Prints shadow_rays (the same work as the others'), cpu_ms, and last the milliseconds of a picture on the wall. Needs AVX-512
// to be a limit of machines that have it; elsewhere the compiler makes two or four vectors of one.
#include <immintrin.h>

#include "support/scene.hpp"

constexpr int LANES = 16;
typedef float F __attribute__((vector_size(4 * LANES)));
typedef int I __attribute__((vector_size(4 * LANES)));   // a mask, or whole numbers

static inline F all(float value) { return F{} + value; }
#ifdef __AVX512F__
static inline bool any(I mask) { return _mm512_test_epi32_mask(__m512i(mask), __m512i(mask)); }
static inline int count(I mask) { return __builtin_popcount(_mm512_test_epi32_mask(__m512i(mask), __m512i(mask))); }
static inline F root(F x) { return F(_mm512_sqrt_ps(__m512(x))); }
static inline F of_object(const float* column, I object) {
    return F(_mm512_permutexvar_ps(__m512i(object), _mm512_loadu_ps(column)));
}
#else
static inline bool any(I mask) {
    int sum = 0;
    for (int i = 0; i < LANES; i++) sum |= mask[i];
    return sum != 0;
}
static inline int count(I mask) {
    int sum = 0;
    for (int i = 0; i < LANES; i++) sum -= mask[i];
    return sum;
}
static inline F root(F x) {
    F y;
    for (int i = 0; i < LANES; i++) y[i] = __builtin_sqrtf(x[i]);
    return y;
}
static inline F of_object(const float* column, I object) {
    F values;
    for (int i = 0; i < LANES; i++) values[i] = column[object[i]];
    return values;
}
#endif
static inline F least(F a, F b) { return a < b ? a : b; }
static inline F most(F a, F b) { return a > b ? a : b; }
static inline F floor_of(F x) {
    F whole = __builtin_convertvector(__builtin_convertvector(x, I), F);
    return whole > x ? whole - 1 : whole;
}
static inline F from_bits(I x) { return reinterpret_cast<F>(x); }
static inline I to_bits(F x) { return reinterpret_cast<I>(x); }

// 2^x for x from -126 to 0: Taylor's series of the fraction.
static inline F exp2_of(F x) {
    x = most(x, all(-126));
    F whole = floor_of(x), f = (x - whole) * 0.69314718f;
    F series = 1 + f * (1 + f * (0.5f + f * (0.16666667f + f * (0.041666668f + f * 0.0083333333f))));
    return series * from_bits((__builtin_convertvector(whole, I) + 127) << 23);
}

// The logarithm to base 2 of 0 < x <= 1: atanh's series of the mantissa.
static inline F log2_of(F x) {
    I bits = to_bits(x);
    F exponent = __builtin_convertvector((bits >> 23) - 127, F), m = from_bits((bits & 0x7fffff) | 0x3f800000);
    I large = m > 1.4142135f;
    m = large ? m * 0.5f : m, exponent = large ? exponent + 1 : exponent;
    F q = (m - 1) / (m + 1), s = q * q;
    return exponent + q * 2.8853901f * (1 + s * (0.33333334f + s * (0.2f + s * 0.14285715f)));
}

struct V { F x, y, z; };
static inline V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline V operator*(V a, F s) { return {a.x * s, a.y * s, a.z * s}; }
static inline F dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline V wide(Vec v) { return {all(v.x), all(v.y), all(v.z)}; }
static inline V choose(I mask, V a, V b) { return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z}; }

struct Plane { Vec normal; float offset; };
static Scene scene;
static std::vector<std::vector<Plane>> pyramids;
static float color_r[LANES], color_g[LANES], color_b[LANES], ambient[LANES], diffuse[LANES], specular[LANES],
    reflection[LANES], shininess[LANES];   // by object, 0 is the board

struct Hit { F t; I object; V normal; };

// Takes a hit where there is a nearer one.
static inline void take(Hit& hit, I nearer, F t, int object, V normal) {
    hit.t = nearer ? t : hit.t;
    hit.object = nearer ? I{} + object : hit.object;
    hit.normal = choose(nearer, normal, hit.normal);
}

// Calls met(mask, t, object, normal) for each object that some active ray meets before `reach`; whether to go on is its answer.
template <class Met> static inline void meet(V o, V d, I active, const F& reach, Met met) {
    int object = 1;
    for (const Sphere& s : scene.spheres) {
        V c = wide({s.x, s.y, s.z}) - o;
        F along = dot(c, d);
        V across = c - d * along;
        F rest = s.radius * s.radius - dot(across, across);
        I in = active & (rest > 0);
        if (any(in)) {
            F t = along - root(most(rest, all(0)));
            in &= (t > NEAR) & (t < reach);
            if (any(in) && !met(in, t, object, [&] { return (d * t - c) * all(1 / s.radius); })) return;
        }
        object++;
    }
    V inverse{1 / d.x, 1 / d.y, 1 / d.z};
    for (const Solid& cube : scene.cubes) {
        V low = wide(cube.corner) - o, high = low + V{all(cube.width), all(cube.width), all(cube.width)};
        F x0 = low.x * inverse.x, x1 = high.x * inverse.x, y0 = low.y * inverse.y, y1 = high.y * inverse.y;
        F z0 = low.z * inverse.z, z1 = high.z * inverse.z;
        F x = least(x0, x1), y = least(y0, y1), z = least(z0, z1);
        F t = most(x, most(y, z)), leave = least(most(x0, x1), least(most(y0, y1), most(z0, z1)));
        I in = active & (t > NEAR) & (t < leave) & (t < reach);
        auto normal = [&] {
            I is_x = t == x, is_y = ~is_x & (t == y), is_z = ~is_x & ~is_y;
            auto against = [](I axis, F d) { return axis ? (d > 0 ? all(-1) : all(1)) : all(0); };
            return V{against(is_x, d.x), against(is_y, d.y), against(is_z, d.z)};
        };
        if (any(in) && !met(in, t, object, normal)) return;
        object++;
    }
    for (const auto& planes : pyramids) {
        F enter = all(-INFINITY), leave = reach;
        V facing{};
        for (const Plane& plane : planes) {
            V n = wide(plane.normal);
            F speed = dot(n, d), t = (plane.offset - dot(n, o)) / speed;
            I entering = speed < 0, later = entering & (t > enter);
            enter = later ? t : enter;
            facing = choose(later, n, facing);
            leave = ~entering & (t < leave) ? t : leave;
        }
        I in = active & (enter > NEAR) & (enter < leave);
        if (any(in) && !met(in, enter, object, [&] { return facing; })) return;
        object++;
    }
}

static inline Hit closest(V o, V d, I active) {
    F t = -o.z / d.z;
    Hit hit{(t > NEAR) ? t : all(INFINITY), {}, wide({0, 0, 1})};
    meet(o, d, active, hit.t, [&](I in, F t, int object, auto normal) { return take(hit, in, t, object, normal()), true; });
    return hit;
}

// Those of the active rays that reach their light.
static inline I reaches(V o, V d, I active, F distance) {
    I free = active;
    meet(o, d, active, distance, [&](I in, F, int, auto) { return free &= ~in, any(free); });
    return free;
}

static V trace(V o, V d, long& shadow_rays) {
    V color{};
    F weight = all(1);
    I active = ~I{};
    for (int step = 0; step < scene.level; step++) {
        Hit hit = closest(o, d, active);
        active &= hit.t < INFINITY;
        if (!any(active)) break;
        hit.t = active ? hit.t : all(0);
        V point = o + d * hit.t, from = point + hit.normal * all(NEAR);
        V mirrored = d - hit.normal * (2 * dot(d, hit.normal));
        F cells = floor_of(point.x / scene.cell) + floor_of(point.y / scene.cell);
        I black = (hit.object == 0) & ((__builtin_convertvector(cells, I) & 1) != 0);
        V own{of_object(color_r, hit.object), of_object(color_g, hit.object), of_object(color_b, hit.object)};
        own = choose(black, V{}, own);
        F light = of_object(ambient, hit.object);
        F matt = of_object(diffuse, hit.object), gloss = of_object(specular, hit.object), power = of_object(shininess, hit.object);
        for (const Light& lamp : scene.lights) {
            V to = wide(lamp.position) - point;
            F squared = dot(to, to), inverse = 1 / root(squared);
            to = to * inverse;
            F cosine = dot(to, hit.normal);
            I asks = active & (cosine > 0);
            if (lamp.is_spot) asks &= dot(to, wide(lamp.axis)) <= -lamp.least_cosine;
            if (!any(asks)) continue;
            shadow_rays += count(asks);
            I lit = reaches(from, to, asks, squared * inverse * 0.9999f);
            if (!any(lit)) continue;
            F phong = dot(mirrored, to);
            F highlight = gloss * exp2_of(power * log2_of(most(phong, all(1e-9f))));
            F fade = exp2_of(squared * (lamp.falloff * -1.442695f));
            light += lit ? fade * (matt * cosine + ((phong > 0) & (gloss > 0) ? highlight : all(0))) : all(0);
        }
        color = color + own * (active ? light * weight : all(0));
        weight *= of_object(reflection, hit.object);
        active &= weight > 0;
        o = from, d = mirrored;
    }
    return color;
}

// Five planes with the inside behind them.
static std::vector<Plane> planes_of(const Solid& p) {
    float half = p.width / 2;
    Vec apex = p.corner + Vec{half, half, p.height};
    std::vector<Plane> planes{{{0, 0, -1}, -p.corner.z}};
    for (Vec normal : {Vec{p.height, 0, half}, {-p.height, 0, half}, {0, p.height, half}, {0, -p.height, half}})
        planes.push_back({unit(normal), dot(unit(normal), apex)});
    return planes;
}

static void add_surface(int object, const Surface& s) {
    color_r[object] = s.color.x, color_g[object] = s.color.y, color_b[object] = s.color.z, ambient[object] = s.ambient;
    diffuse[object] = s.diffuse, specular[object] = s.specular, reflection[object] = s.reflection, shininess[object] = s.shininess;
}

// A block of 4 x 4 pixels.
static V block_color(int column, int row, long& shadow_rays) {
    F x, y;
    for (int i = 0; i < LANES; i++) x[i] = column + i % 4 + 0.5f, y[i] = row + i / 4 + 0.5f;
    float step = 2.0f / scene.pixels;
    F across = (x * step - 1) * half_width(scene), upward = (1 - y * step) * half_height(scene);
    V d = wide(scene.look) + wide(scene.right) * across + wide(scene.up) * upward;
    return trace(wide(scene.eye), d * (1 / root(dot(d, d))), shadow_rays);
}

int main(int words, char** text) {
    scene = scene_of(words, text);
    if (scene.spheres.size() + scene.cubes.size() + scene.pyramids.size() >= LANES || scene.pixels % 4) return 1;
    int object = 0;
    add_surface(object++, scene.board);
    for (const Surface& surface : scene.sphere_surfaces) add_surface(object++, surface);
    for (const Solid& cube : scene.cubes) add_surface(object++, cube.surface);
    for (const Solid& pyramid : scene.pyramids) {
        pyramids.push_back(planes_of(pyramid));
        add_surface(object++, pyramid.surface);
    }
    size_t across = scene.pixels / 4;
    std::vector<V> film(across * across);
    std::atomic<long> shadow_rays{0};
    Median median = measure([&] {
        shadow_rays = 0;
        in_parallel(across * across, across, [&](size_t first, size_t end) {
            long mine = 0;
            for (size_t at = first; at < end; at++) film[at] = block_color(int(at % across * 4), int(at / across * 4), mine);
            shadow_rays += mine;
        });
    });
    show("shadow_rays", double(shadow_rays));
    show("cpu_ms", median.cpu * 1e3);
    show("ms", median.wall * 1e3);
}
