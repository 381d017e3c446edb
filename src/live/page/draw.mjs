/* SPDX-License-Identifier: MIT */
/* A canvas with a world on it: metres, y upward. Letters are as large as those of the page. */

export function colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

export class Painter {
    constructor(canvas) {
        this.canvas = canvas;
        this.c = canvas.getContext('2d');
    }

    /* Clears it; the rectangle x, y +- half width, half height is seen whole. part: of the height, from the top. */
    begin() {
        const ratio = window.devicePixelRatio || 1, box = this.canvas.getBoundingClientRect();
        const w = Math.max(1, Math.round(box.width * ratio)), h = Math.max(1, Math.round(box.height * ratio));
        if (this.canvas.width !== w || this.canvas.height !== h) this.canvas.width = w, this.canvas.height = h;
        this.ink = colour('ink'), this.faint = colour('faint'), this.line = colour('line'), this.fill = colour('fill');
        this.paper = colour('paper'), this.slide = colour('slide'), this.roll = colour('roll');
        this.em = ratio * parseFloat(getComputedStyle(document.documentElement).fontSize);
        this.ratio = ratio;
        this.width = w, this.height = h;
        this.c.setTransform(1, 0, 0, 1, 0, 0);
        this.c.clearRect(0, 0, w, h);
        this.box = {x: 0, y: 0, w, h};
    }

    /* box: part of the canvas in pixels {x, y, w, h}. */
    view(x, y, halfWidth, halfHeight, box = this.box) {
        this.scale = Math.min(box.w / (2 * halfWidth), box.h / (2 * halfHeight));
        this.x0 = box.x + box.w / 2 - this.scale * x;
        this.y0 = box.y + box.h / 2 + this.scale * y;
        this.box = box;
    }

    px(x) {
        return this.x0 + this.scale * x;
    }
    py(y) {
        return this.y0 - this.scale * y;
    }
    /* From a pointer on the page to the world. */
    world(event) {
        const box = this.canvas.getBoundingClientRect();
        return [
            ((event.clientX - box.left) * this.ratio - this.x0) / this.scale,
            (this.y0 - (event.clientY - box.top) * this.ratio) / this.scale
        ];
    }

    path(points, colour_, width = .08) {
        this.c.beginPath();
        points.forEach(([x, y], i) =>
                           i ? this.c.lineTo(this.px(x), this.py(y)) : this.c.moveTo(this.px(x), this.py(y)));
        this.c.strokeStyle = colour_, this.c.lineWidth = width * this.em;
        this.c.stroke();
    }

    circle(x, y, radius, {fill, stroke, width = .08} = {}) {
        this.c.beginPath();
        this.c.arc(this.px(x), this.py(y), Math.max(0, radius * this.scale), 0, 2 * Math.PI);
        if (fill) this.c.fillStyle = fill, this.c.fill();
        if (stroke) this.c.strokeStyle = stroke, this.c.lineWidth = width * this.em, this.c.stroke();
    }

    /* A part of a rim, counter-clockwise from one angle to another. */
    arc(x, y, radius, from, to, colour_, width = .25) {
        this.c.beginPath();
        this.c.arc(this.px(x), this.py(y), radius * this.scale, -from, -to, to > from);
        this.c.strokeStyle = colour_, this.c.lineWidth = width * this.em;
        this.c.stroke();
    }

    arrow(x, y, dx, dy, colour_, {width = .14, both = false} = {}) {
        const length = Math.hypot(dx, dy) * this.scale, head = Math.min(.6 * this.em, .6 * length);
        if (length < 1) return;
        const a = Math.atan2(-dy, dx), c = this.c;
        const tip = (px, py, turn) => {
            c.beginPath();
            c.moveTo(px, py);
            for (const s of [-1, 1])
                c.lineTo(px - head * Math.cos(a + turn + .45 * s), py - head * Math.sin(a + turn + .45 * s));
            c.closePath(), c.fillStyle = colour_, c.fill();
        };
        this.path([[x, y], [x + dx * (1 - .5 * head / length), y + dy * (1 - .5 * head / length)]], colour_, width);
        tip(this.px(x + dx), this.py(y + dy), 0);
        if (both) tip(this.px(x), this.py(y), Math.PI);
    }

    text(text, x, y, {colour: colour_ = this.ink, align = 'center', size = 1, base = 'middle', bold = false} = {}) {
        this.label(text, this.px(x), this.py(y), {colour: colour_, align, size, base, bold});
    }

    label(text, px, py, {colour: colour_ = this.ink, align = 'left', size = 1, base = 'middle', bold = false} = {}) {
        this.c.font = `${bold ? 700 : 400} ${size * this.em}px "DejaVu Sans", system-ui, sans-serif`;
        this.c.textAlign = align, this.c.textBaseline = base, this.c.fillStyle = colour_;
        this.c.fillText(text, px, py);
    }

    /* Curves over one axis. curves: [{points: [[x, y]], colour, dash, name}], dots: [[x, y]],
     * texts: [[x, y, text]]; box in pixels. */
    chart(box, {x: [x0, x1], y: [y0, y1], xName, yName, curves, dots = [], texts = []}) {
        const c = this.c, left = box.x + 3.2 * this.em, right = box.x + box.w - .6 * this.em;
        const top = box.y + 1.3 * this.em, bottom = box.y + box.h - 1.7 * this.em;
        const at =
            ([x, y]) => [left + (right - left) * (x - x0) / (x1 - x0), bottom - (bottom - top) * (y - y0) / (y1 - y0)];
        c.strokeStyle = this.line, c.lineWidth = .05 * this.em;
        c.strokeRect(left, top, right - left, bottom - top);
        for (const y of [y0, (y0 + y1) / 2, y1])
            this.label(short(y), left - .3 * this.em, at([x0, y])[1], {align: 'right', size: .8});
        for (const x of [x0, x1])
            this.label(short(x), at([x, y0])[0], bottom + .8 * this.em, {align: x === x0 ? 'left' : 'right', size: .8});
        this.label(xName, (left + right) / 2, bottom + .8 * this.em, {align: 'center', size: .8});
        this.label(yName, left, top - .7 * this.em, {size: .8});
        c.save();
        c.beginPath(), c.rect(left, top, right - left, bottom - top), c.clip();
        for (const curve of curves) {
            c.beginPath();
            curve.points.forEach((p, i) => i ? c.lineTo(...at(p)) : c.moveTo(...at(p)));
            c.setLineDash(curve.dash ? [.4 * this.em, .3 * this.em] : []);
            c.strokeStyle = curve.colour, c.lineWidth = (curve.width ?? .14) * this.em, c.stroke();
        }
        c.restore();
        c.setLineDash([]);
        for (const dot of dots)
            c.beginPath(), c.arc(...at(dot), .3 * this.em, 0, 2 * Math.PI), c.fillStyle = this.ink, c.fill();
        for (const [x, y, text] of texts) this.label(text, ...at([x, y]), {align: 'center', size: .9});
        this.names(
            curves.filter(k => k.name && k.points.length > 1).map(k => [k.name, ...at(k.points[k.points.length - 1])]),
            left, right, top, bottom);
    }

    /* Beside the ends of curves, one below the other. */
    names(list, left, right, top, bottom) {
        const gap = .95 * this.em;
        let below = top;
        for (const [name, px, py] of list.sort((a, b) => a[2] - b[2])) {
            const y = Math.max(below + .55 * this.em, py - .6 * this.em);
            const behind = px < left + .5 * (right - left); /* there is more room behind the end */
            this.label(name, Math.min(px, right) + (behind ? .3 : -.3) * this.em, Math.min(y, bottom - .5 * this.em),
                       {align: behind ? 'left' : 'right', size: .8});
            below = y + gap - .55 * this.em;
        }
    }
}

/* Three digits, no zeros behind. */
export function short(value) {
    if (!isFinite(value)) return '–';
    const rounded = Number(value.toPrecision(3));
    return (Math.abs(rounded) < 5e-7 ? '0' : String(rounded)).replace('-', '−');
}
