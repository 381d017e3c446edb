// SPDX-License-Identifier: MIT
// Keys, films and copying. The page is XML too: no less-than sign and no ampersand in here.
"use strict";
const demos = Array.from(document.querySelectorAll("article"));
const still = matchMedia("(prefers-reduced-motion: reduce)");

// The demonstration that is read: the last whose top has passed the upper third of the window; -1 above the first.
function current() {
    return demos.filter(d => innerHeight / 3 >= d.getBoundingClientRect().top).length - 1;
}

// At once, not smoothly: a key pressed again must find the page where it is going.
function go(to) {
    const demo = demos[Math.max(0, Math.min(demos.length - 1, to))];
    location.replace("#" + demo.id);
    demo.focus();
}

function toggle(film) {
    if (film.paused) film.play();
    else film.pause();
}

// Keys that what has the focus needs itself stay with it: a film seeks and plays, a text scrolls, a button is pressed.
addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
    const own = event.target.closest("video, pre, .scroll"), pressed = event.target.closest("video, button, summary");
    const at = current(), key = event.key;
    if (key === "n" || (key === "ArrowRight" ? !own : false)) go(at + 1);
    else if (key === "p" || (key === "ArrowLeft" ? !own : false)) go(at - 1);
    else if (key === " " ? !pressed : false) {
        const film = demos[at] ? demos[at].querySelector("video") : null;
        if (!film) return;
        toggle(film);
    } else return;
    event.preventDefault();
});

// A film starts when most of it is seen and stops when it has gone; who wants no motion starts it himself.
const most = 0.6;
const seen = new IntersectionObserver(entries => entries.forEach(entry => {
    if (most > entry.intersectionRatio) entry.target.pause();
    else if (!still.matches) entry.target.play().catch(() => {});
}), {threshold: most});
document.querySelectorAll("video").forEach(film => seen.observe(film));

// A page from a file may not be allowed to use the clipboard: then the text is selected, ready for Ctrl+C.
document.querySelectorAll("button.copy").forEach(button => button.addEventListener("click", async () => {
    const text = document.getElementById(button.dataset.of), said = button.parentNode.querySelector("[role=status]");
    try {
        await navigator.clipboard.writeText(text.textContent);
        said.textContent = "copied";
    } catch {
        getSelection().selectAllChildren(text);
        said.textContent = "selected: press Ctrl+C";
    }
}));
