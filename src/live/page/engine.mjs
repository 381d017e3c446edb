/* SPDX-License-Identifier: MIT */
/* The library as a JavaScript object. Nothing is computed here: text goes in, numbers come out of its memory. */

export const ROLLING = 0, SLIDING = 1;

/* A page has no files and no environment. A write to stderr is a failed assertion: it goes to the console. */
function system(memory) {
    const none = 8; /* EBADF */
    const zero = (...at) => {
        for (const a of at) new DataView(memory().buffer).setUint32(a, 0, true);
        return 0;
    };
    return {
        environ_get: () => 0,
        environ_sizes_get: zero,
        fd_close: () => none,
        fd_prestat_get: () => none,
        fd_prestat_dir_name: () => none,
        fd_read: () => none,
        fd_seek: () => none,
        fd_write: (fd, vectors, n, written) => {
            const view = new DataView(memory().buffer);
            let text = '', size = 0;
            for (let i = 0; i < n; i++) {
                const at = view.getUint32(vectors + 8 * i, true), length = view.getUint32(vectors + 8 * i + 4, true);
                text += new TextDecoder().decode(new Uint8Array(memory().buffer, at, length));
                size += length;
            }
            console.error(text);
            view.setUint32(written, size, true);
            return 0;
        },
        proc_exit: code => { throw new Error('the library ended with code ' + code); },
    };
}

const DISK = ['x', 'y', 'angle', 'vx', 'vy', 'spin', 'fx', 'fy', 'torque', 'radius', 'mass'];
const TOUCH =
    ['x', 'y', 'nx', 'ny', 'overlap', 'f_n', 'f_t', 'moment_a', 'moment_b', 'v_s', 'v_r', 's1', 's2', 'mobilisation'];
const MOTION = ['R1', 'R2', 'x1', 'y1', 'vx1', 'vy1', 'w1', 'x2', 'y2', 'vx2', 'vy2', 'w2'];

export async function loadEngine(bytes) {
    let exports;
    const module = await WebAssembly.compile(bytes);
    const instance = await WebAssembly.instantiate(module, {wasi_snapshot_preview1: system(() => exports.memory)});
    exports = instance.exports;
    exports._initialize();
    return new Engine(exports);
}

class Engine {
    constructor(exports) {
        this.c = exports;
        this.stride = exports.live_touch_size() / 8;
        this.rolling = this.names(ROLLING);
        this.sliding = this.names(SLIDING);
    }

    doubles(at, n) {
        return new Float64Array(this.c.memory.buffer, at, n);
    }

    text(at) {
        const bytes = new Uint8Array(this.c.memory.buffer, at);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    write(text) {
        const bytes = new TextEncoder().encode(text + '\0');
        if (bytes.length > this.c.live_room()) throw new Error('the case is too long');
        new Uint8Array(this.c.memory.buffer, this.c.live_text(), bytes.length).set(bytes);
    }

    check(code) {
        if (code) throw new Error(this.text(this.c.live_error()));
    }

    names(kind) {
        return Array.from({length: this.c.live_definitions(kind)},
                          (_, i) => this.text(this.c.live_definition(kind, i)));
    }

    version() {
        return this.text(this.c.live_version());
    }

    /* A case as `trundle run` takes it, in a slot from 0 to 3. Throws what the command would print. */
    open(slot, text) {
        this.write(text);
        this.check(this.c.live_open(slot));
        return new World(this, slot);
    }

    /* A closed cycle of one contact, with laws as they stand in `contact`. */
    cycle(laws, {R1, R2, overlap, du, dtheta}) {
        this.write(laws);
        this.check(this.c.live_cycle_open(R1, R2, overlap, du, dtheta));
        return new Cycle(this);
    }

    /* The inside of one contact along the path of a case of kind: patch. */
    inside(text) {
        this.write(text);
        this.check(this.c.live_inside_open());
        return new Inside(this);
    }

    /* motion: {R1, R2, x1, y1, vx1, vy1, w1, x2, ...}, what is missing is 0; R1 Infinity: a floor. By each
     * definition. */
    measure(motion) {
        const m = this.doubles(this.c.live_motion(), MOTION.length);
        MOTION.forEach((name, i) => { m[i] = motion[name] ?? 0; });
        const of = (kind, names) => Object.fromEntries(names.map((name, i) => [name, this.c.live_measure(kind, i)]));
        return {rolling: of(ROLLING, this.rolling), sliding: of(SLIDING, this.sliding)};
    }
}

class World {
    constructor(engine, slot) {
        this.engine = engine;
        this.c = engine.c;
        this.slot = slot;
        this.count = this.c.live_count(slot);
        this.dt = this.c.live_dt(slot);
        this.steps = 0;
    }

    step(n) {
        this.engine.check(this.c.live_step(this.slot, n));
        this.steps += n;
    }

    time() {
        return this.c.live_time(this.slot);
    }

    /* Disk i lies at 11 i: see DISK. Valid until the next call. */
    disks() {
        return this.engine.doubles(this.c.live_disks(this.slot), DISK.length * this.count);
    }

    disk(i) {
        const all = this.disks();
        return Object.fromEntries(DISK.map((name, k) => [name, all[DISK.length * i + k]]));
    }

    /* n contacts; numbers() begins each with its two bodies. */
    touches() {
        const n = this.c.live_contacts(this.slot);
        if (n < 0) this.engine.check(1);
        const at = this.c.live_touches(this.slot), stride = this.engine.stride;
        const ids = new Int32Array(this.c.memory.buffer, at, 2 * stride * n),
              numbers = this.engine.doubles(at, stride * n);
        return {n, stride, a: i => ids[2 * stride * i], b: i => ids[2 * stride * i + 1], numbers};
    }

    touch(i) {
        const all = this.touches();
        if (i >= all.n) return null;
        const out = {a: all.a(i), b: all.b(i)};
        TOUCH.forEach((name, k) => { out[name] = all.numbers[all.stride * i + 1 + k]; });
        return out;
    }

    biaxial() {
        const [strain, stress1, stress2, sinPhi, voidRatio] = this.engine.doubles(this.c.live_biaxial(this.slot), 5);
        return {strain, stress1, stress2, sinPhi, voidRatio};
    }

    setVelocity(i, vx, vy, spin) {
        this.engine.check(this.c.live_velocity(this.slot, i, vx, vy, spin));
    }

    setLaws(text) {
        this.engine.write(text);
        this.engine.check(this.c.live_laws(this.slot));
    }

    hash() {
        return BigInt.asUintN(64, this.c.live_hash(this.slot)).toString(16).padStart(16, '0');
    }
}

const CYCLE = ['R1', 'R2', 'overlap', 'du', 'dtheta', 'beta', 'theta1', 'work', 'pull', 'torque1', 'torque2'];

/* It steps as a world does. A leg takes a second. */
class Cycle {
    constructor(engine) {
        this.engine = engine;
        this.leg = engine.c.live_cycle_leg();
        this.dt = 1 / this.leg;
        this.steps = 0;
        this.work = [0]; /* after each tenth of a leg [J/m] */
    }

    step(n) {
        const tenth = this.leg / 10;
        for (let few; n > 0; n -= few) {
            few = Math.min(n, tenth - this.steps % tenth);
            this.engine.check(this.engine.c.live_cycle_go(few));
            this.steps += few;
            if (this.steps % tenth === 0) this.work.push(this.state().work);
        }
    }

    time() {
        return this.steps * this.dt;
    }

    state() {
        const all = this.engine.doubles(this.engine.c.live_cycle_state(), CYCLE.length);
        return Object.fromEntries(CYCLE.map((name, k) => [name, all[k]]));
    }
}

const INSIDE = ['steps', 'n', 'rolls', 'P', 'a', 'Q', 'q', 'u_slide', 'u_roll', 'creepage', 'stick', 'dissipated'];

/* It steps as a world does, 50 steps a second. */
class Inside {
    constructor(engine) {
        this.engine = engine;
        this.dt = 1 / 50;
        this.steps = 0;
    }

    step(n) {
        this.engine.check(this.engine.c.live_inside_go(n));
        this.steps = this.state().steps;
    }

    time() {
        return this.steps * this.dt;
    }

    state() {
        const all = this.engine.doubles(this.engine.c.live_inside_state(), INSIDE.length);
        return Object.fromEntries(INSIDE.map((name, k) => [name, all[k]]));
    }

    elements() {
        const n = this.state().n, all = this.engine.doubles(this.engine.c.live_inside_elements(), 5 * n);
        return Array.from(
            {length: n},
            (_, i) =>
                ({x: all[5 * i], p: all[5 * i + 1], tau: all[5 * i + 2], slip: all[5 * i + 3], side: all[5 * i + 4]}));
    }
}
