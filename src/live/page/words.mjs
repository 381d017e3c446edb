/* SPDX-License-Identifier: MIT */
/* All texts, by a name with points: word('scene.rim.title'). {x} is replaced by what is given for x. */

export function word(name, values = {}) {
    let at = WORDS;
    for (const part of name.split('.')) at = at?.[part];
    if (at === undefined) return name;
    return typeof at === 'string' ? at.replace(/\{(\w+)\}/g, (_, key) => values[key] ?? '') : at;
}
