/* SPDX-License-Identifier: MIT */
/* What a contact does, in a word and in bars. */
import {short} from './draw.mjs';
import {word} from './words.mjs';

/* Slower than a thousandth of the scale counts as still: a slider cannot do better. */
export function lampOf(vs, vr, scale) {
    const slides = Math.abs(vs) > 1e-3 * scale, rolls = Math.abs(vr) > 1e-3 * scale;
    return slides ? rolls ? 'BOTH' : 'SLIDES' : rolls ? 'ROLLS' : 'NEITHER';
}

export function element(tag, attributes = {}, ...children) {
    const e = document.createElement(tag);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on'))
            e.addEventListener(key.slice(2), value);
        else if (value === true)
            e.setAttribute(key, '');
        else if (value !== false && value !== undefined)
            e.setAttribute(key, value);
    }
    e.append(...children);
    return e;
}

/* A number as a bar to the left or to the right of zero. kind: slide, roll or plain. */
function bar(kind, name, value, scale, unit) {
    const share = Math.max(-1, Math.min(1, value / scale)), fill = element('b');
    fill.style.left = `${50 + Math.min(0, 50 * share)}%`, fill.style.width = `${Math.abs(50 * share)}%`;
    return element('div', {class: `bar ${kind}`}, `${name} ${short(value)} ${unit}`,
                   element('div', {class: 'track secret'}, fill));
}

/* The readings of a scene:
 *   contacts: [{name, vs, vr}], scale: largest velocity of the bars [m/s], bars: [[name, value, scale, unit]],
 *   sentence,   lines: [[name, text]], tasks: [text], definitions: {rolling: {...}, sliding: {...}} */
export function fillPanel(panel, title, r, {covered, expert}) {
    panel.className = covered ? 'covered' : '';
    const out = [element('h2', {}, title)];
    if (covered)
        out.push(element('p', {class: 'hint'}, word('ui.covered')));
    else {
        for (const k of r.contacts ?? []) {
            const lamp = lampOf(k.vs, k.vr, r.scale);
            out.push(element('div', {class: `lamp ${lamp}`}, element('i'),
                             (k.name ? k.name + ' ' : '') + word('lamp.' + lamp)));
            out.push(bar('slide', word('ui.slides'), k.vs, r.scale, 'm/s'),
                     bar('roll', word('ui.rolls'), k.vr, r.scale, 'm/s'));
        }
        for (const b of r.bars ?? []) out.push(bar('plain', ...b));
        for (const [name, value] of r.lines ?? []) out.push(element('div', {}, `${name}: ${value}`));
        for (const task of r.tasks ?? []) out.push(element('div', {}, `${word('pair.task')}: ${task}`));
        out.push(element('p', {}, r.sentence ?? ''));
        if (expert && r.definitions) out.push(table(r.definitions));
    }
    panel.replaceChildren(...out);
}

function table(definitions) {
    const rows = [];
    for (const kind of ['rolling', 'sliding']) {
        rows.push(element('tr', {}, element('th', {colspan: 2}, word('ui.' + kind))));
        for (const [name, value] of Object.entries(definitions[kind]))
            rows.push(element('tr', {}, element('td', {}, name),
                              element('td', {}, short(value) + (name === 'tordesillas' ? ' rad/s' : ' m/s'))));
    }
    return element('table', {}, ...rows);
}
