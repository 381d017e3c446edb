/* SPDX-License-Identifier: MIT */
/* The whole of libtrundle in one page: two disks collide head on. With a linear spring and dashpot the ratio of the
 * speeds after and before is exp(-pi z/sqrt(1 - z^2)), z the damping ratio, if the force may pull at the end; here it
 * may not, and the contact ends earlier [Schwager2007]. Prints the measured and the exact ratio. */
#include <math.h>
#include <stdio.h>
#include <trundle.h>

/* Schwager and Poeschel 2007, for z < 1/sqrt(2). */
static double exact(double z) {
    double w = sqrt(1 - z * z);
    return exp(-z / w * (acos(-1) - atan(2 * z * w / (1 - 2 * z * z))));
}

int main(void) {
    const char *scene_text = "kind: bodies\n"
                             "time_end: 20 ms\n"
                             "contact: {k_n: 1 MPa, damping_ratio: 0.1, friction: none, rolling: none}\n"
                             "step: {safety: 0.01}\n"
                             "disks:\n"
                             "  - {radius: 10 mm, x: -10.5 mm, y: 0, vx: 1 m/s}\n"
                             "  - {radius: 10 mm, x: 10.5 mm, y: 0, vx: -1 m/s}\n";
    trundle_error error;
    trundle_disk disk;
    trundle_scene *scene = trundle_scene_read("two disks", scene_text, NULL, 0, &error);
    trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
    int code = world ? TRUNDLE_OK : error.code;
    while (!code && trundle_world_time(world) < 20e-3) code = trundle_world_step(world, 100, &error);
    if (!code) code = trundle_world_disk(world, 1, &disk, &error);
    if (code)
        fprintf(stderr, "%s\n", error.text);
    else
        printf("%.6f %.6f\n", disk.vx, exact(0.1));
    trundle_world_free(world);
    trundle_scene_free(scene);
    return code;
}
