"""Formulas and their meanings as a derivation may give them, with all that has to be escaped."""

import re

ALIGNED = (
    r"\begin{aligned} m x'' &= -k x + "
    + " + ".join(["u_{\\mathrm{r}}"] * 40)
    + r" \\ \text{<i>none</i>} &< \frac{1}{2} \end{aligned}"
)
MEANINGS = {
    "plain": "Plain & *stressed* text with $x_1'' \\le 1$ and <b>no tag</b>.",
    "list": "- This one is no list.",
    "long": "$(a+b)^2 + \\left|c-d\\right| = e - f + g$",
    "short": "$a = b + c$",
    "leading": "$a = -b$",
    "between": "$a - b$",
    "name": r"$2\operatorname{tr}(M)$",
    "function": r"$\sin x$",
    "primes": "$x_1''$",
    "bars": r"$\left| x \right|^2$",
    "stops": "Here ($x$) and $y$, and $z$ too.",
}


def given_formulas(orbit, section):
    """One formula with a note, and one for each meaning, of one section alone."""
    if (orbit, section) != ("rigid-stop/one-impact", "The reduction"):
        return ()
    return ((ALIGNED, "What $m$ is."), *(("x", text) for text in MEANINGS.values()))


def notes(page):
    """The HTML of each meaning on the page, by its name."""
    shown = r'<div class="equation">(?:(?!</div>).)*</div>\s*<p>(.*?)</p>'
    return dict(zip(("aligned", *MEANINGS), re.findall(shown, page, re.DOTALL), strict=False))
