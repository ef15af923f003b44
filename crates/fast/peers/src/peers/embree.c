/* As much of Embree 3 as the race needs. */
#include <embree3/rtcore.h>
#include <stdint.h>
#include <string.h>

struct race { RTCDevice device; RTCScene scene; };
struct ray { float o[3], d[3], t_min, t_max; };
struct hit { float t; uint32_t prim; };

void *race_build(const float *corners, size_t corner_count, const uint32_t *triangles, size_t triangle_count, int high)
{
    static struct race races[64];
    static int count;
    if (count == 64) return 0;
    struct race *race = &races[count++];
    race->device = rtcNewDevice("threads=1");
    if (!race->device) return 0;
    race->scene = rtcNewScene(race->device);
    rtcSetSceneBuildQuality(race->scene, high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry mesh = rtcNewGeometry(race->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *v = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, corner_count);
    uint32_t *t = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangle_count);
    memcpy(v, corners, 12 * corner_count);
    memcpy(t, triangles, 12 * triangle_count);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(race->scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(race->scene);
    return race;
}

static struct RTCRay one(const struct ray *ray)
{
    struct RTCRay own = {
        .org_x = ray->o[0], .org_y = ray->o[1], .org_z = ray->o[2], .tnear = ray->t_min,
        .dir_x = ray->d[0], .dir_y = ray->d[1], .dir_z = ray->d[2], .time = 0, .tfar = ray->t_max, .mask = -1,
    };
    return own;
}

void race_nearest(void *race, const struct ray *rays, struct hit *hits, size_t count)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < count; i++) {
        struct RTCRayHit both = { .ray = one(&rays[i]), .hit = { .geomID = RTC_INVALID_GEOMETRY_ID } };
        rtcIntersect1(((struct race *)race)->scene, &context, &both);
        hits[i].t = both.ray.tfar;
        hits[i].prim = both.hit.geomID == RTC_INVALID_GEOMETRY_ID ? UINT32_MAX : both.hit.primID;
    }
}

void race_nearest16(void *race, const struct ray *rays, struct hit *hits, size_t count)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (size_t first = 0; first + 16 <= count; first += 16) {
        struct RTCRayHit16 all;
        int32_t valid[16] __attribute__((aligned(64)));
        for (int i = 0; i < 16; i++) {
            const struct ray *ray = &rays[first + i];
            valid[i] = -1;
            all.ray.org_x[i] = ray->o[0]; all.ray.org_y[i] = ray->o[1]; all.ray.org_z[i] = ray->o[2];
            all.ray.dir_x[i] = ray->d[0]; all.ray.dir_y[i] = ray->d[1]; all.ray.dir_z[i] = ray->d[2];
            all.ray.tnear[i] = ray->t_min; all.ray.tfar[i] = ray->t_max;
            all.ray.time[i] = 0; all.ray.mask[i] = -1; all.ray.id[i] = 0; all.ray.flags[i] = 0;
            all.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID; all.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, ((struct race *)race)->scene, &context, &all);
        for (int i = 0; i < 16; i++) {
            hits[first + i].t = all.ray.tfar[i];
            hits[first + i].prim = all.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? UINT32_MAX : all.hit.primID[i];
        }
    }
    size_t done = count / 16 * 16;
    race_nearest(race, rays + done, hits + done, count - done);
}

void race_any(void *race, const struct ray *rays, uint8_t *hits, size_t count)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < count; i++) {
        struct RTCRay own = one(&rays[i]);
        rtcOccluded1(((struct race *)race)->scene, &context, &own);
        hits[i] = own.tfar < 0;
    }
}
