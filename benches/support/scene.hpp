// What the C++ programs of this folder share: our scene files, the camera, threads and clocks.
#pragma once

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <time.h>
#include <vector>

struct Vec { float x, y, z; };
static inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline Vec operator*(Vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
static inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static inline Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Surface { Vec color; float ambient, diffuse, specular, reflection, shininess; };
struct Sphere { float x, y, z, radius; };
struct Solid { Vec corner; float width, height; Surface surface; };
struct Light { Vec position; float falloff; bool is_spot; Vec axis; float least_cosine; };

// Cubes and pyramids as triangles.
struct Triangles {
    std::vector<Vec> corners;          // three each
    std::vector<Surface> surfaces;     // one each

    void face(std::initializer_list<Vec> around, const Surface& surface) {
        const Vec* c = around.begin();
        for (size_t i = 2; i < around.size(); i++) {
            corners.insert(corners.end(), {c[0], c[i - 1], c[i]});
            surfaces.push_back(surface);
        }
    }

    void cube(const Solid& cube) {
        auto at = [&](int x, int y, int z) { return cube.corner + Vec{float(x), float(y), float(z)} * cube.width; };
        face({at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, cube.surface);
        face({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)}, cube.surface);
        face({at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, cube.surface);
        face({at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)}, cube.surface);
        face({at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}, cube.surface);
        face({at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}, cube.surface);
    }

    void pyramid(const Solid& p) {
        Vec a = p.corner, b = a + Vec{p.width, 0, 0}, c = a + Vec{p.width, p.width, 0}, d = a + Vec{0, p.width, 0};
        Vec apex = a + Vec{p.width / 2, p.width / 2, p.height};
        face({a, d, c, b}, p.surface);
        for (auto [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) face({from, to, apex}, p.surface);
    }
};

// What a ray that starts on a surface does not see.
constexpr float NEAR = 2e-3f;

struct Scene {
    float fovy, aspect, cell;
    Surface board;   // of its white cells
    int level, pixels;
    std::vector<Sphere> spheres;
    std::vector<Surface> sphere_surfaces;
    std::vector<Solid> cubes, pyramids;
    std::vector<Light> lights;
    Vec eye, look, right, up;
};

// A text without its comments.
static std::string without_comments(const char* path) {
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {}), kept;
    kept.reserve(text.size());
    bool comment = false;
    for (char c : text) {
        comment = c == '#' || (comment && c != '\n');
        if (!comment) kept += c;
    }
    return kept;
}

struct Words {
    const char* at;
    float number() {
        char* end;
        float value = std::strtof(at, &end);
        if (end == at) { std::fprintf(stderr, "the scene does not read\n"); std::exit(1); }
        at = end;
        return value;
    }
    Vec vec() { float x = number(), y = number(), z = number(); return {x, y, z}; }
    std::string word() {
        while (std::isspace(static_cast<unsigned char>(*at))) at++;
        std::string word;
        while (*at && !std::isspace(static_cast<unsigned char>(*at))) word += *at++;
        return word;
    }
};

static Surface read_surface(Words& words) {
    Vec color = words.vec();
    float ambient = words.number(), diffuse = words.number(), specular = words.number();
    float reflection = words.number(), shininess = words.number();
    return {color, ambient, diffuse, specular, reflection, shininess};
}

static Scene read_scene(const char* path) {
    std::string text = without_comments(path);
    Words words{text.c_str()};
    Scene scene;
    words.number(), words.number();   // the clipping planes hold every object of these scenes
    scene.fovy = words.number(), scene.aspect = words.number();
    scene.level = int(words.number()), scene.pixels = int(words.number());
    scene.cell = words.number();
    float ambient = words.number(), diffuse = words.number();
    scene.board = {{1, 1, 1}, ambient, diffuse, 0, words.number(), 0};
    for (int count = int(words.number()); count > 0; count--) {
        std::string kind = words.word();
        Vec place = words.vec();
        float size = words.number(), height = kind == "pyramid" ? words.number() : size;
        Surface surface = read_surface(words);
        if (kind == "sphere") {
            scene.spheres.push_back({place.x, place.y, place.z, size});
            scene.sphere_surfaces.push_back(surface);
        } else {
            (kind == "cube" ? scene.cubes : scene.pyramids).push_back({place, size, height, surface});
        }
    }
    for (int count = int(words.number()); count > 0; count--) {
        Vec place = words.vec();
        scene.lights.push_back({place, words.number(), false, {}, 0});
    }
    for (int count = int(words.number()); count > 0; count--) {
        Vec place = words.vec();
        float falloff = words.number();
        Vec axis = unit(words.vec() - place);
        scene.lights.push_back({place, falloff, true, axis, std::cos(words.number() * float(M_PI) / 180)});
    }
    return scene;
}

static int threads = 2, repeats = 5;
static std::string what = "frame";

static Vec three(const char* text) {
    Vec v{};
    std::sscanf(text, "%f,%f,%f", &v.x, &v.y, &v.z);
    return v;
}

// The scene that the command line names, with its camera.
static Scene scene_of(int count, char** words) {
    if (count < 2) { std::fprintf(stderr, "give SCENE --eye X,Y,Z --look X,Y,Z\n"); std::exit(2); }
    Scene scene = read_scene(words[1]);
    Vec look{0, 1, 0};
    scene.eye = {0, -150, 50};
    for (int i = 2; i + 1 < count; i += 2) {
        std::string flag = words[i];
        if (flag == "--eye") scene.eye = three(words[i + 1]);
        if (flag == "--look") look = three(words[i + 1]);
        if (flag == "--size") scene.pixels = std::atoi(words[i + 1]);
        if (flag == "--threads") threads = std::atoi(words[i + 1]);
        if (flag == "--repeats") repeats = std::atoi(words[i + 1]);
        if (flag == "--what") what = words[i + 1];
    }
    scene.look = unit(look);
    scene.right = unit(cross(scene.look, {0, 0, 1}));
    scene.up = cross(scene.right, scene.look);
    return scene;
}

static inline float half_width(const Scene& s) { return std::tan(s.fovy * s.aspect * float(M_PI) / 360); }
static inline float half_height(const Scene& s) { return std::tan(s.fovy * float(M_PI) / 360); }

static double seconds(clockid_t clock) {
    timespec t;
    clock_gettime(clock, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

// Calls work(first, end) for pieces of 0..count on all threads.
static void in_parallel(size_t count, size_t piece, const std::function<void(size_t, size_t)>& work) {
    std::atomic<size_t> next{0};
    auto run = [&] {
        for (size_t at; (at = next.fetch_add(piece)) < count;) work(at, std::min(at + piece, count));
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; i++) others.emplace_back(run);
    run();
    for (auto& other : others) other.join();
}

struct Median { double wall, cpu; };

// Seconds of a piece of work, which is done once before.
static Median measure(const std::function<void()>& work) {
    std::vector<double> walls, cpus;
    work();
    for (int i = 0; i < repeats; i++) {
        double wall = seconds(CLOCK_MONOTONIC), cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
        work();
        cpus.push_back(seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
        walls.push_back(seconds(CLOCK_MONOTONIC) - wall);
    }
    std::sort(walls.begin(), walls.end()), std::sort(cpus.begin(), cpus.end());
    return {walls[walls.size() / 2], cpus[cpus.size() / 2]};
}

static void show(const std::string& name, double value) { std::printf("%s %.6g\n", name.c_str(), value); }
