/* SPDX-License-Identifier: MIT */
/* Pair finding by Box2D's dynamic tree of boxes (the only user of Box2D).
 *
 * Box2D computes in float, in metres of a game, with a fixed fat margin of 0.1: a millimetre disk would be smaller than
 * the margin and every pair a candidate. So lengths are scaled to a unit of two mean diameters, an origin is
 * subtracted, and boxes are rounded outward. The tree only proposes pairs. The gap is then checked in double, so this
 * finder and brute force give the same pairs. Every disk is queried at every call: Box2D's own UpdatePairs reports a
 * pair once and would miss it if disks part and meet again. No exception leaves this file.
 *
 * In a periodic cell the images of a disk's box that meet any disk of the cell are queried too: those of disks within
 * r + r_max + skin of an edge (r + skin would miss pairs at the corners, and large partners).
 */
extern "C" {
#include "broad/broad_internal.h"
}
#include <algorithm>
#include <box2d/b2_dynamic_tree.h>
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

/* Box2D does not check its allocator. These two replace it, here and inside the library, and throw if memory runs
 * out. */
void *b2Alloc_Default(int32 size) {
    void *memory = std::malloc(static_cast<std::size_t>(size));
    if (!memory) throw std::bad_alloc();
    return memory;
}
void b2Free_Default(void *memory) {
    std::free(memory);
}

namespace {

/* The queries of one thread, and the pairs that it found. */
struct Share {
    std::vector<int> near; /* partners of the disk that is being queried */
    std::vector<int> a, b;
    bool failed; /* out of memory: no exception may leave a thread */
};

struct Box2d {
    b2DynamicTree tree;
    std::vector<int32> proxy; /* of disk i */
    std::vector<Share> shares;
    double scale, x0, y0;

    float down(double v) const { return std::nextafter(static_cast<float>(v), -INFINITY); }
    float up(double v) const { return std::nextafter(static_cast<float>(v), INFINITY); }

    b2AABB box(const double *p, double skin, double shift_x = 0, double shift_y = 0) const {
        double x = (p[0] + shift_x - x0) * scale, y = (p[1] + shift_y - y0) * scale, r = (p[3] + skin) * scale;
        b2AABB b;
        b.lowerBound.Set(down(x - r), down(y - r));
        b.upperBound.Set(up(x + r), up(y + r));
        return b;
    }
};

/* b2DynamicTree::Query calls this. Only partners with a larger number: each pair once. */
struct Collect {
    const Box2d *self;
    const tr_broad_input *input;
    std::vector<int> *near;
    int a;
    bool QueryCallback(int32 proxy) {
        int b = static_cast<int>(reinterpret_cast<uintptr_t>(self->tree.GetUserData(proxy)));
        if (b > a && tr_broad_near(input, a, b)) near->push_back(b);
        return true;
    }
};

bool out_of_memory(const tr_broad_input *input, tr_status *st) {
    return tr_status_fail(st, TR_FILE, "error: out of memory (pair finding, %d disks)", input->n);
}

void *create(const tr_broad_input *input, tr_status *st) {
    if (!tr_broad_check(input, st)) return nullptr;
    try {
        auto *self = new Box2d;
        double sum = 0;
        for (int i = 0; i < input->n; i++) sum += input->pos[4 * static_cast<size_t>(i) + 3];
        self->scale = input->n ? input->n / (4 * sum) : 1;
        self->x0 = input->n ? input->pos[0] : 0;
        self->y0 = input->n ? input->pos[1] : 0;
        for (int i = 0; i < input->n; i++)
            self->proxy.push_back(self->tree.CreateProxy(self->box(input->pos + 4 * static_cast<size_t>(i), 0),
                                                         reinterpret_cast<void *>(static_cast<uintptr_t>(i))));
        return self;
    } catch (const std::bad_alloc &) {
        out_of_memory(input, st);
        return nullptr;
    }
}

struct Job {
    Box2d *self;
    const tr_broad_input *input;
    int threads;
    b2AABB all; /* of the boxes of all disks */
};

/* The queries of thread k. */
void query(void *context, int k) {
    const Job *job = static_cast<const Job *>(context);
    const Box2d &self = *job->self;
    const tr_broad_input *input = job->input;
    Share &share = job->self->shares[static_cast<size_t>(k)];
    int high = tr_threads_chunk(input->n, k + 1, job->threads);
    try {
        share.failed = false;
        share.a.clear(), share.b.clear();
        for (int a = tr_threads_chunk(input->n, k, job->threads); a < high; a++) {
            share.near.clear();
            Collect collect{&self, input, &share.near, a};
            const double *p = input->pos + 4 * static_cast<size_t>(a);
            self.tree.Query(&collect, self.box(p, input->skin));
            for (int image = 0; image < 9 && input->cell; image++) {
                if (image == 4) continue; /* itself */
                int column = image % 3 - 1, row = image / 3 - 1;
                b2AABB box = self.box(p, input->skin, column * input->cell[0], row * input->cell[1]);
                if (b2TestOverlap(box, job->all)) self.tree.Query(&collect, box);
            }
            std::sort(share.near.begin(), share.near.end());
            share.a.insert(share.a.end(), share.near.size(), a);
            share.b.insert(share.b.end(), share.near.begin(), share.near.end());
        }
    } catch (const std::bad_alloc &) {
        share.failed = true;
    }
}

bool find(void *finder, const tr_broad_input *input, tr_pairs *pairs, tr_status *st) {
    if (!tr_broad_check(input, st)) return false;
    auto *self = static_cast<Box2d *>(finder);
    int n = tr_threads_count(input->threads);
    size_t found = 0;
    pairs->n = 0;
    try {
        self->shares.resize(static_cast<size_t>(n));
        for (int i = 0; i < input->n; i++)
            self->tree.MoveProxy(self->proxy[static_cast<size_t>(i)],
                                 self->box(input->pos + 4 * static_cast<size_t>(i), 0), b2Vec2(0, 0));
    } catch (const std::bad_alloc &) {
        return out_of_memory(input, st);
    }
    b2AABB all = input->n ? self->box(input->pos, 0) : b2AABB{};
    for (int i = 0; i < input->n; i++) all.Combine(self->tree.GetFatAABB(self->proxy[static_cast<size_t>(i)]));
    Job job{self, input, n, all};
    tr_threads_run(input->threads, query, &job);
    for (const Share &s : self->shares)
        if (s.failed) return out_of_memory(input, st);
    for (const Share &s : self->shares) found += s.a.size();
    if (!tr_pairs_reserve(pairs, found, st)) return false;
    for (const Share &s : self->shares) {
        std::copy(s.a.begin(), s.a.end(), pairs->a + pairs->n);
        std::copy(s.b.begin(), s.b.end(), pairs->b + pairs->n);
        pairs->n += static_cast<int>(s.a.size());
    }
    return true;
}

void destroy(void *finder) {
    delete static_cast<Box2d *>(finder);
}

} // namespace

extern "C" const tr_broad_finder tr_broad_box2d = {"box2d", create, find, destroy};
