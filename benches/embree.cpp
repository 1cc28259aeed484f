// The same pictures and the same rays through Intel's Embree (3.13 or newer of that line), for benches/peers.sh.
//
//   embree SCENE --eye X,Y,Z --look X,Y,Z [--size N] [--threads N] [--repeats N] [--what frame|rays|build]
//
// Reads our scene files. Spheres go in as Embree's own sphere points, and as user geometry with a callback of ours: which is
// faster depends on the scene. Cubes and pyramids are triangles, the infinite board is met outside of Embree. Rays are
// handed over one by one, eight at a time and sixteen at a time. Prints a line "NAME VALUE" for each measurement:
//   build_MODE     milliseconds
//   bytes_MODE     bytes that Embree holds
//   frame_MODE     milliseconds of a whole picture on the wall (median), cpu_frame_MODE its processor milliseconds
//   CLASS_MODE     millions of rays a second of one kind, by processor time times threads
//   shadow_rays    shadow rays of the picture, to see that the work is the same
// MODE is points1, points8, points16, user1, user8 or user16; CLASS is primary, shadow, mirror or random.
#include <embree3/rtcore.h>

#include <random>

#include "support/scene.hpp"

// Cubes and pyramids.
static Triangles triangles;

// ---- Embree -----------------------------------------------------------------------------------------------------

static RTCDevice device;
static std::atomic<long> embree_bytes{0};
static bool count_bytes(void*, ssize_t bytes, bool) { embree_bytes += bytes; return true; }

static void sphere_bounds(const RTCBoundsFunctionArguments* args) {
    const Sphere& s = static_cast<const Sphere*>(args->geometryUserPtr)[args->primID];
    *args->bounds_o = {s.x - s.radius, s.y - s.radius, s.z - s.radius, 0, s.x + s.radius, s.y + s.radius, s.z + s.radius, 0};
}

// Where a ray of length 1 meets a sphere beyond `near`, or infinity; the middle of the chord first, which stays exact for
// spheres far away.
static inline float meet_sphere(const Sphere& s, Vec o, Vec d, float near) {
    Vec c = Vec{s.x, s.y, s.z} - o;
    float along = dot(c, d);
    Vec across = c - d * along;
    float rest = s.radius * s.radius - dot(across, across);
    if (rest < 0) return INFINITY;
    float half = std::sqrt(rest);
    return along - half > near ? along - half : along + half > near ? along + half : INFINITY;
}

static void meet_spheres(const RTCIntersectFunctionNArguments* args) {
    unsigned n = args->N;
    RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, n);
    const Sphere& s = static_cast<const Sphere*>(args->geometryUserPtr)[args->primID];
    for (unsigned i = 0; i < n; i++) {
        if (!args->valid[i]) continue;
        Vec o{RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i)};
        Vec d{RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i)};
        float t = meet_sphere(s, o, d, RTCRayN_tnear(ray, n, i));
        if (!(t < RTCRayN_tfar(ray, n, i))) continue;
        RTCRayN_tfar(ray, n, i) = t;
        RTCHitN_geomID(hit, n, i) = args->geomID;
        RTCHitN_primID(hit, n, i) = args->primID;
    }
}

static void hide_behind_spheres(const RTCOccludedFunctionNArguments* args) {
    unsigned n = args->N;
    const Sphere& s = static_cast<const Sphere*>(args->geometryUserPtr)[args->primID];
    for (unsigned i = 0; i < n; i++) {
        if (!args->valid[i]) continue;
        RTCRayN* ray = args->ray;
        Vec o{RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i)};
        Vec d{RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i)};
        if (meet_sphere(s, o, d, RTCRayN_tnear(ray, n, i)) < RTCRayN_tfar(ray, n, i)) RTCRayN_tfar(ray, n, i) = -INFINITY;
    }
}

enum { SPHERES, TRIANGLES };

static RTCScene build(Scene& scene, bool user) {
    RTCScene built = rtcNewScene(device);
    if (!scene.spheres.empty()) {
        auto type = user ? RTC_GEOMETRY_TYPE_USER : RTC_GEOMETRY_TYPE_SPHERE_POINT;
        RTCGeometry spheres = rtcNewGeometry(device, type);
        if (user) {
            rtcSetGeometryUserPrimitiveCount(spheres, unsigned(scene.spheres.size()));
            rtcSetGeometryUserData(spheres, scene.spheres.data());
            rtcSetGeometryBoundsFunction(spheres, sphere_bounds, nullptr);
            rtcSetGeometryIntersectFunction(spheres, meet_spheres);
            rtcSetGeometryOccludedFunction(spheres, hide_behind_spheres);
        } else {
            rtcSetSharedGeometryBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, scene.spheres.data(), 0,
                                       sizeof(Sphere), scene.spheres.size());
        }
        rtcCommitGeometry(spheres);
        rtcAttachGeometryByID(built, spheres, SPHERES);
        rtcReleaseGeometry(spheres);
    }
    if (!triangles.corners.empty()) {
        RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        size_t count = triangles.corners.size();
        auto* corners = static_cast<Vec*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                  RTC_FORMAT_FLOAT3, sizeof(Vec), count));
        std::copy(triangles.corners.begin(), triangles.corners.end(), corners);
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count / 3));
        for (unsigned i = 0; i < count; i++) indices[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometryByID(built, mesh, TRIANGLES);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(built);
    return built;
}

// Embree's rays, K at a time.
template <int K> struct Wide;
template <> struct Wide<1> {
    using Ray = RTCRay; using RayHit = RTCRayHit;
    static void meet(const int*, RTCScene s, RTCIntersectContext* c, RayHit* r) { rtcIntersect1(s, c, r); }
    static void hide(const int*, RTCScene s, RTCIntersectContext* c, Ray* r) { rtcOccluded1(s, c, r); }
};
template <> struct Wide<8> {
    using Ray = RTCRay8; using RayHit = RTCRayHit8;
    static void meet(const int* v, RTCScene s, RTCIntersectContext* c, RayHit* r) { rtcIntersect8(v, s, c, r); }
    static void hide(const int* v, RTCScene s, RTCIntersectContext* c, Ray* r) { rtcOccluded8(v, s, c, r); }
};
template <> struct Wide<16> {
    using Ray = RTCRay16; using RayHit = RTCRayHit16;
    static void meet(const int* v, RTCScene s, RTCIntersectContext* c, RayHit* r) { rtcIntersect16(v, s, c, r); }
    static void hide(const int* v, RTCScene s, RTCIntersectContext* c, Ray* r) { rtcOccluded16(v, s, c, r); }
};

struct Flight { Vec origin, direction; float far; };
struct Found { unsigned geometry, primitive; float t; };

// Rays with origin, direction and reach in, what they meet out. K rays that all have valid[i] != 0 count.
template <int K> static void put(typename Wide<K>::Ray& rays, int i, const Flight& f) {
    auto* n = reinterpret_cast<RTCRayN*>(&rays);
    RTCRayN_org_x(n, K, i) = f.origin.x, RTCRayN_org_y(n, K, i) = f.origin.y, RTCRayN_org_z(n, K, i) = f.origin.z;
    RTCRayN_dir_x(n, K, i) = f.direction.x, RTCRayN_dir_y(n, K, i) = f.direction.y, RTCRayN_dir_z(n, K, i) = f.direction.z;
    RTCRayN_tnear(n, K, i) = NEAR, RTCRayN_tfar(n, K, i) = f.far, RTCRayN_time(n, K, i) = 0;
    RTCRayN_mask(n, K, i) = ~0u, RTCRayN_id(n, K, i) = 0, RTCRayN_flags(n, K, i) = 0;
}

template <int K> static void closest(RTCScene scene, bool coherent, const int* valid, const Flight* in, Found* out) {
    alignas(64) typename Wide<K>::RayHit rays;
    auto* hits = RTCRayHitN_HitN(reinterpret_cast<RTCRayHitN*>(&rays), K);
    auto* ends = RTCRayHitN_RayN(reinterpret_cast<RTCRayHitN*>(&rays), K);
    for (int i = 0; i < K; i++) {
        if (!valid[i]) continue;
        put<K>(rays.ray, i, in[i]);
        RTCHitN_geomID(hits, K, i) = RTCHitN_instID(hits, K, i, 0) = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    Wide<K>::meet(valid, scene, &context, &rays);
    for (int i = 0; i < K; i++)
        if (valid[i]) out[i] = {RTCHitN_geomID(hits, K, i), RTCHitN_primID(hits, K, i), RTCRayN_tfar(ends, K, i)};
}

template <int K> static void occluded(RTCScene scene, const int* valid, const Flight* in, bool* out) {
    alignas(64) typename Wide<K>::Ray rays;
    for (int i = 0; i < K; i++)
        if (valid[i]) put<K>(rays, i, in[i]);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    Wide<K>::hide(valid, scene, &context, &rays);
    for (int i = 0; i < K; i++)
        if (valid[i]) out[i] = RTCRayN_tfar(reinterpret_cast<RTCRayN*>(&rays), K, i) < 0;
}

// ---- light ------------------------------------------------------------------------------------------------------

static Vec pixel_direction(const Scene& s, int column, int row) {
    float across = (2 * (column + 0.5f) / s.pixels - 1) * half_width(s);
    float upward = (1 - 2 * (row + 0.5f) / s.pixels) * half_height(s);
    return unit(s.look + s.right * across + s.up * upward);
}

// Where a ray meets the board, or infinity.
static float meet_board(Vec o, Vec d) {
    float t = -o.z / d.z;
    return t > NEAR ? t : INFINITY;
}

static Flight flight(Vec o, Vec d) { return {o, d, meet_board(o, d)}; }

struct Spot { Vec point, normal; Surface surface; };

static Spot spot_at(const Scene& s, const Flight& f, const Found& found) {
    Vec point = f.origin + f.direction * found.t;
    if (found.geometry == SPHERES) {
        const Sphere& sphere = s.spheres[found.primitive];
        return {point, unit(point - Vec{sphere.x, sphere.y, sphere.z}), s.sphere_surfaces[found.primitive]};
    }
    Vec normal{0, 0, 1};
    if (found.geometry == TRIANGLES) {
        const Vec* c = &triangles.corners[3 * found.primitive];
        normal = unit(cross(c[1] - c[0], c[2] - c[0]));
    }
    if (dot(normal, f.direction) > 0) normal = normal * -1;
    if (found.geometry == TRIANGLES) return {point, normal, triangles.surfaces[found.primitive]};
    bool black = (long(std::floor(point.x / s.cell)) + long(std::floor(point.y / s.cell))) & 1;
    Surface surface = s.board;
    if (black) surface.color = {};
    return {point, normal, surface};
}

static float lit(const Light& light, const Spot& spot, Vec mirrored, Vec to_light, float distance) {
    float phong = std::max(0.0f, dot(mirrored, to_light));
    float highlight = spot.surface.specular > 0 ? spot.surface.specular * std::pow(phong, spot.surface.shininess) : 0;
    float fade = std::exp(-distance * distance * light.falloff);
    return fade * (spot.surface.diffuse * dot(spot.normal, to_light) + highlight);
}

// K paths from the eye, step by step: the colour of each.
template <int K>
static void trace(const Scene& s, RTCScene built, Flight* flights, Vec* colors, long& shadow_rays) {
    alignas(64) int alive[K], asked[K];
    float weights[K];
    std::fill_n(alive, K, -1), std::fill_n(weights, K, 1.0f), std::fill_n(colors, K, Vec{});
    for (int step = 0; step < s.level; step++) {
        Found found[K];
        closest<K>(built, step == 0, alive, flights, found);
        Spot spots[K];
        Vec mirrored[K];
        for (int i = 0; i < K; i++) {
            if (!alive[i]) continue;
            alive[i] = std::isfinite(found[i].t) ? -1 : 0;
            if (!alive[i]) continue;
            spots[i] = spot_at(s, flights[i], found[i]);
            mirrored[i] = flights[i].direction - spots[i].normal * (2 * dot(flights[i].direction, spots[i].normal));
            colors[i] = colors[i] + spots[i].surface.color * (weights[i] * spots[i].surface.ambient);
        }
        for (const Light& light : s.lights) {
            Flight towards[K];
            float distances[K];
            bool hidden[K], any = false;
            for (int i = 0; i < K; i++) {
                asked[i] = 0;
                if (!alive[i]) continue;
                Vec to = light.position - spots[i].point;
                distances[i] = std::sqrt(dot(to, to));
                to = to * (1 / distances[i]);
                if (dot(to, spots[i].normal) <= 0 || (light.is_spot && -dot(to, light.axis) < light.least_cosine)) continue;
                towards[i] = {spots[i].point + spots[i].normal * NEAR, to, distances[i] * 0.9999f};
                asked[i] = -1, any = true, shadow_rays++;
            }
            if (!any) continue;
            occluded<K>(built, asked, towards, hidden);
            for (int i = 0; i < K; i++)
                if (asked[i] && !hidden[i])
                    colors[i] = colors[i] + spots[i].surface.color *
                        (weights[i] * lit(light, spots[i], mirrored[i], towards[i].direction, distances[i]));
        }
        for (int i = 0; i < K; i++) {
            if (!alive[i]) continue;
            weights[i] *= spots[i].surface.reflection;
            alive[i] = weights[i] > 0 ? -1 : 0;
            flights[i] = flight(spots[i].point + spots[i].normal * NEAR, mirrored[i]);
        }
        if (std::find(alive, alive + K, -1) == alive + K) return;
    }
}

// ---- measuring --------------------------------------------------------------------------------------------------

// Pixels of square blocks, block after block, so that rays that go together are neighbours.
static std::vector<std::pair<int, int>> pixels_by_block(int side) {
    std::vector<std::pair<int, int>> pixels;
    for (int block = 0; block < ((side + 3) / 4) * ((side + 3) / 4); block++) {
        int column = block % ((side + 3) / 4) * 4, row = block / ((side + 3) / 4) * 4;
        for (int i = 0; i < 16; i++)
            if (column + i % 4 < side && row + i / 4 < side) pixels.push_back({column + i % 4, row + i / 4});
    }
    return pixels;
}

template <int K> static void measure_frame(const Scene& s, RTCScene built, const std::string& mode) {
    auto pixels = pixels_by_block(s.pixels);
    std::vector<Vec> film(size_t(s.pixels) * s.pixels);
    std::atomic<long> shadow_rays{0};
    auto frame = [&] {
        shadow_rays = 0;
        in_parallel(pixels.size(), 1024, [&](size_t first, size_t end) {
            long mine = 0;
            for (size_t at = first; at < end; at += K) {
                Flight flights[K];
                Vec colors[K];
                for (size_t i = 0; i < K; i++) {
                    auto [column, row] = pixels[std::min(at + i, end - 1)];
                    flights[i] = flight(s.eye, pixel_direction(s, column, row));
                }
                trace<K>(s, built, flights, colors, mine);
                for (size_t i = 0; i < K && at + i < end; i++)
                    film[size_t(pixels[at + i].second) * s.pixels + pixels[at + i].first] = colors[i];
            }
            shadow_rays += mine;
        });
    };
    Median median = measure(frame);
    show("frame_" + mode + std::to_string(K), median.wall * 1e3);
    show("cpu_frame_" + mode + std::to_string(K), median.cpu * 1e3);
    show("shadow_rays", double(shadow_rays));
}

template <int K>
static void measure_rays(RTCScene built, const std::vector<Flight>& flights, const char* kind, const std::string& mode) {
    bool is_shadow = kind == std::string("shadow"), coherent = kind == std::string("primary");
    std::atomic<long> met{0};
    Median median = measure([&] {
        met = 0;
        in_parallel(flights.size(), 4096, [&](size_t first, size_t end) {
            long mine = 0;
            for (size_t at = first; at + K <= end; at += K) {
                alignas(64) int valid[K];
                std::fill_n(valid, K, -1);
                Found found[K];
                bool hidden[K];
                if (is_shadow) occluded<K>(built, valid, &flights[at], hidden);
                else closest<K>(built, coherent, valid, &flights[at], found);
                for (int i = 0; i < K; i++) mine += is_shadow ? hidden[i] : found[i].geometry != RTC_INVALID_GEOMETRY_ID;
            }
            met += mine;
        });
    });
    show(kind + ("_" + mode) + std::to_string(K), flights.size() / 1e6 / (median.cpu / threads));
}

struct Kinds { std::vector<Flight> primary, shadow, mirror, random; };

// Every pixel's ray, what follows from it at its hit for the first light, and as many rays from anywhere to anywhere.
static Kinds kinds_of_rays(const Scene& s, RTCScene built) {
    Kinds kinds;
    std::mt19937 bits(1);
    auto any = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(bits); };
    const int valid = -1;
    for (auto [column, row] : pixels_by_block(s.pixels)) {
        Flight start = flight(s.eye, pixel_direction(s, column, row));
        kinds.primary.push_back(start);
        Vec direction;
        do direction = {any(-1, 1), any(-1, 1), any(-1, 1)};
        while (dot(direction, direction) > 1 || dot(direction, direction) < 0.01f);
        kinds.random.push_back({{any(-100, 100), any(-100, 100), any(0, 100)}, unit(direction), INFINITY});
        Found found;
        closest<1>(built, true, &valid, &start, &found);
        if (!std::isfinite(found.t)) continue;
        Spot spot = spot_at(s, start, found);
        Vec from = spot.point + spot.normal * NEAR, to = s.lights[0].position - spot.point;
        float distance = std::sqrt(dot(to, to));
        if (dot(to, spot.normal) > 0) kinds.shadow.push_back({from, to * (1 / distance), distance * 0.9999f});
        kinds.mirror.push_back(flight(from, start.direction - spot.normal * (2 * dot(start.direction, spot.normal))));
    }
    return kinds;
}

template <int K> static void measure_kinds(RTCScene built, const Kinds& kinds, const std::string& mode) {
    measure_rays<K>(built, kinds.primary, "primary", mode);
    measure_rays<K>(built, kinds.shadow, "shadow", mode);
    measure_rays<K>(built, kinds.mirror, "mirror", mode);
    measure_rays<K>(built, kinds.random, "random", mode);
}

int main(int count, char** words) {
    Scene scene = scene_of(count, words);
    for (const Solid& cube : scene.cubes) triangles.cube(cube);
    for (const Solid& pyramid : scene.pyramids) triangles.pyramid(pyramid);
    scene.spheres.reserve(scene.spheres.size() + 1);   // Embree reads a little beyond the last

    device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, nullptr);
    for (bool user : {false, true}) {
        std::string mode = user ? "user" : "points";
        double start = seconds(CLOCK_MONOTONIC);
        RTCScene built = build(scene, user);
        show("build_" + mode, (seconds(CLOCK_MONOTONIC) - start) * 1e3);
        show("bytes_" + mode, double(embree_bytes));
        if (what == "frame") {
            measure_frame<1>(scene, built, mode), measure_frame<8>(scene, built, mode), measure_frame<16>(scene, built, mode);
        } else if (what == "rays") {
            Kinds kinds = kinds_of_rays(scene, built);
            measure_kinds<1>(built, kinds, mode), measure_kinds<8>(built, kinds, mode), measure_kinds<16>(built, kinds, mode);
        }
        rtcReleaseScene(built);
    }
    rtcReleaseDevice(device);
}
