// SPDX-License-Identifier: MIT
// Predict, then run: a film stands still under its question, with its readouts covered, until an answer is chosen or revealed.
// The page is XML too: no less-than sign and no ampersand in here.
"use strict";
const demos = Array.from(document.querySelectorAll("article"));
const still = matchMedia("(prefers-reduced-motion: reduce)");
const words = document.body.dataset;
const card = document.getElementById("keys");
let read = -1; // the demonstration that fills the screen, where one does

// The demonstration that is read: the last whose top has passed the upper third of the window; -1 above the first.
function current() {
    if (document.body.classList.contains("full")) return read;
    return demos.filter(d => innerHeight / 3 >= d.getBoundingClientRect().top).length - 1;
}

// At once, not smoothly: a key pressed again must find the page where it is going.
function go(to) {
    read = Math.max(0, Math.min(demos.length - 1, to));
    demos.forEach((d, i) => {
        d.classList.toggle("current", i === read);
        if (i !== read) films(d).forEach(film => film.pause());
    });
    location.replace("#" + demos[read].id);
    scrollTo(0, demos[read].getBoundingClientRect().top + scrollY);
    demos[read].focus({preventScroll: true});
}

function films(demo) {
    return Array.from(demo.querySelectorAll("video"));
}

function shown(demo) {
    return demo ? demo.querySelector(".variant:not([hidden]) video") : null;
}

function play(film) {
    if (film) film.play().catch(() => {});
}

function toggle(film) {
    if (film.paused) play(film);
    else film.pause();
}

// Uncovers the readouts, says what is right, and runs; who wants no motion starts the film himself. chosen 0: none.
function reveal(demo, chosen) {
    const right = Number(demo.dataset.right), buttons = Array.from(demo.querySelectorAll(".choices button"));
    buttons.forEach(button => {
        const n = Number(button.dataset.n);
        button.classList.toggle("right", n === right);
        button.classList.toggle("wrong", n === chosen ? n !== right : false);
    });
    const best = buttons[right - 1] ? buttons[right - 1].textContent : "";
    demo.querySelector(".verdict").textContent = chosen === 0 ? "" : chosen === right ? words.right : words.wrong.replace("%s", best);
    demo.querySelectorAll(".revealed").forEach(part => { part.hidden = false; });
    demo.querySelectorAll(".act").forEach(part => { part.hidden = true; });
    demo.classList.add("open");
    if (!still.matches) play(shown(demo));
}

function choose(demo, n) {
    const button = demo.querySelectorAll(".choices button")[n - 1];
    if (button) reveal(demo, n);
    return Boolean(button);
}

// All definitions, or the class again: the film goes on where it is.
function expert() {
    const on = document.body.classList.toggle("expert");
    document.querySelectorAll("video[data-expert]").forEach(film => {
        const at = film.currentTime, runs = !film.paused;
        film.src = on ? film.dataset.expert : film.dataset.class;
        film.currentTime = at;
        if (runs) play(film);
    });
}

function full() {
    const on = !document.body.classList.contains("full"), at = Math.max(0, current());
    document.body.classList.toggle("full", on);
    if (on) document.documentElement.requestFullscreen().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen();
    go(at);
}

function help() {
    if (card.open) card.close();
    else card.showModal();
}

document.addEventListener("fullscreenchange", () => {
    if (document.fullscreenElement) return;
    if (!document.body.classList.contains("full")) return;
    document.body.classList.remove("full");
    go(read);
});

// What a key does to the demonstration that is read; false: nothing, the key goes on to the browser.
const keys = {
    "PageDown": at => { go(at + 1); },
    "PageUp": at => { go(at - 1); },
    "n": at => { go(at + 1); },
    "p": at => { go(at - 1); },
    "ArrowRight": (at, own) => own ? false : go(at + 1),
    "ArrowLeft": (at, own) => own ? false : go(at - 1),
    " ": (at, own, pressed) => pressed ? false : shown(demos[at]) ? toggle(shown(demos[at])) : false,
    "r": at => demos[at] ? reveal(demos[at], 0) : false,
    "e": () => { expert(); },
    "f": () => { full(); },
    "?": () => { help(); }
};

// Keys that what has the focus needs itself stay with it: a film seeks and plays, a text scrolls, a button is pressed.
addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
    if (event.target.closest("select") || (card.open ? event.key !== "?" : false)) return;
    const own = event.target.closest("input, pre, .scroll"), pressed = event.target.closest("button, summary, a");
    const at = current(), key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const number = "1234".indexOf(key) + 1;
    const did = key.length === 1 ? number > 0 : false;
    if (did) {
        if (!demos[at] || !choose(demos[at], number)) return;
    } else if (!Object.hasOwn(keys, key) || keys[key](at, own, pressed) === false) return;
    event.preventDefault();
});

demos.forEach(demo => {
    demo.querySelectorAll(".choices button").forEach(button => button.addEventListener("click", () => choose(demo, Number(button.dataset.n))));
    demo.querySelectorAll("button.reveal").forEach(button => button.addEventListener("click", () => reveal(demo, 0)));
    const chooser = demo.querySelector(".chooser select");
    if (!chooser) return;
    chooser.addEventListener("change", () => {
        films(demo).forEach(film => film.pause());
        demo.querySelectorAll(".variant").forEach(variant => { variant.hidden = variant.dataset.name !== chooser.value; });
        if (demo.classList.contains("open") ? !still.matches : false) play(shown(demo));
    });
});
document.querySelector("button.help").addEventListener("click", help);

// Under a film, never over it: play or stop, and where it is.
document.querySelectorAll(".variant").forEach(variant => {
    const film = variant.querySelector("video"), bar = variant.querySelector(".transport");
    if (!film) return;
    const button = bar.querySelector("button"), seek = bar.querySelector("input");
    button.addEventListener("click", () => toggle(film));
    seek.addEventListener("input", () => { film.currentTime = seek.value / 1000 * film.duration; });
    film.addEventListener("click", () => toggle(film));
    film.addEventListener("timeupdate", () => { seek.value = 1000 * film.currentTime / film.duration || 0; });
    film.addEventListener("play", () => { button.textContent = "❚❚"; });
    film.addEventListener("pause", () => { button.textContent = "▶"; });
});

// A film that has gone stops.
const seen = new IntersectionObserver(entries => entries.forEach(entry => {
    if (0.3 > entry.intersectionRatio) entry.target.pause();
}), {threshold: 0.3});
document.querySelectorAll("video").forEach(film => seen.observe(film));

// A page from a file may not be allowed to use the clipboard: then the text is selected, ready for Ctrl+C.
document.querySelectorAll("button.copy").forEach(button => button.addEventListener("click", async () => {
    const text = document.getElementById(button.dataset.of), said = button.parentNode.querySelector("[role=status]");
    try {
        await navigator.clipboard.writeText(text.textContent);
        said.textContent = words.copied;
    } catch {
        getSelection().selectAllChildren(text);
        said.textContent = words.selected;
    }
}));
