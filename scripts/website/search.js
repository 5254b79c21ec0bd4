// SPDX-License-Identifier: AGPL-3.0-or-later
// The sections that hold all words that are typed: those with them in their heading first. `sections` is in sections.js,
// so that no server is needed.
"use strict";

const box = document.getElementById("search");
const list = document.getElementById("results");

function rated(section, words) {
    const title = (section.page + " " + section.title).toLowerCase();
    const text = section.text.toLowerCase();
    let sum = 0;
    for (const word of words) {
        if (!title.includes(word) && !text.includes(word)) return 0;
        sum += (title.includes(word) ? 20 : 0) + Math.min(text.split(word).length - 1, 5);
    }
    return sum;
}

/// The text around the first word, with the words marked.
function excerpt(text, words) {
    const first = Math.min(...words.map((word) => text.toLowerCase().indexOf(word)).filter((at) => at >= 0), text.length);
    const begin = Math.max(text.lastIndexOf(" ", Math.max(first - 50, 0)), 0);
    const part = document.createElement("p");
    let rest = text.slice(begin, begin + 170);
    while (rest) {
        const hits = words.map((word) => [rest.toLowerCase().indexOf(word), word]).filter(([at]) => at >= 0).sort((a, b) => a[0] - b[0]);
        if (!hits.length) break;
        const [at, word] = hits[0];
        part.append(rest.slice(0, at));
        const mark = document.createElement("mark");
        mark.textContent = rest.slice(at, at + word.length);
        part.append(mark);
        rest = rest.slice(at + word.length);
    }
    part.append(rest);
    return part;
}

function show() {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length ? sections.map((section) => [rated(section, words), section]).filter(([sum]) => sum > 0) : [];
    found.sort((a, b) => b[0] - a[0]);
    list.replaceChildren();
    for (const [, section] of found.slice(0, 12)) {
        const link = document.createElement("a");
        link.href = section.href;
        link.textContent = section.page === section.title ? section.title : section.page + ": " + section.title;
        const item = document.createElement("li");
        item.append(link, excerpt(section.text, words));
        list.append(item);
    }
    if (words.length && !found.length) list.append("Nothing found.");
}

box.addEventListener("input", show);
box.value = new URLSearchParams(location.search).get("q") || "";
show();
