/* SPDX-License-Identifier: MIT */
/* A DEM code of one's own that takes its laws from libtrundle: a disk thrown along a floor, with rolling resistance and
 * creep. The loop, its integrator and its bodies are this program's; the contact is the library's. Prints x, vx, spin
 * at the end, and the same from the library's own world. */
#include <math.h>
#include <stdio.h>
#include <trundle.h>

#define LAWS                                                                                                           \
    "k_n: 1 MPa, damping_ratio: 0.2, friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 MPa, E_star: 2.5 MPa, "            \
    "creep_roll: wang, rolling: wang-spring, mu_r: 0.01, k_r: 1 MPa"

static const double R = 0.1, density = 1000, g = 9.81, dt = 1e-5, v0 = 1;
enum { STEPS = 50000 };

static int my_loop(trundle_error *error) {
    const double pi = acos(-1), m = density * pi * R * R, I = m * R * R / 2, y0 = R - m * g / 1e6;
    const trundle_pair pair = {.R1 = 0, .R2 = R, .density2 = density, .ny = 1};
    const trundle_body floor = {0};
    trundle_body disk = {.y = y0, .vx = v0};
    trundle_force f = {0};
    trundle_contact *contact = trundle_contact_new(LAWS, &pair, error);
    for (int n = 0; contact && n < STEPS;
         n++) { /* leapfrog: the disk starts at rest on the floor, so nothing pushes it at first */
        disk.x += dt * disk.vx;
        disk.y += dt * disk.vy;
        if (trundle_contact_step(contact, dt, &floor, &disk, &f, error)) break;
        disk.vx += dt * f.fx / m;
        disk.vy += dt * (f.fy / m - g);
        disk.spin += dt * f.torque2 / I;
    }
    trundle_contact_free(contact);
    if (!error->code)
        printf("%.9f %.9f %.9f\n", disk.x, disk.vx - dt / 2 * f.fx / m, disk.spin - dt / 2 * f.torque2 / I);
    return error->code;
}

static int by_the_library(trundle_error *error) {
    const char *scene_text = "kind: bodies\ntime_end: 0.5\ngravity: {y: -9.81}\nstep: {dt: 1e-5}\ncontact: {" LAWS "}\n"
                             "walls: [{nx: 0, ny: 1}]\n"
                             "disks: [{radius: 0.1, density: 1000, x: 0, y: radius - density*pi*radius^2*(9.81 "
                             "m/s^2)/contact.k_n, vx: 1}]\n";
    trundle_disk disk;
    trundle_scene *scene = trundle_scene_read("thrown disk", scene_text, NULL, 0, error);
    trundle_world *world = scene ? trundle_world_new(scene, error) : NULL;
    if (world && !trundle_world_step(world, STEPS, error) && !trundle_world_disk(world, 0, &disk, error))
        printf("%.9f %.9f %.9f\n", disk.x, disk.vx, disk.spin);
    trundle_world_free(world);
    trundle_scene_free(scene);
    return error->code;
}

int main(void) {
    trundle_error error = {0};
    if (my_loop(&error) || by_the_library(&error)) fprintf(stderr, "%s\n", error.text);
    return error.code;
}
