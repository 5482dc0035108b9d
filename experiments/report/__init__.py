# SPDX-License-Identifier: GPL-3.0-or-later
"""The report: reads the tables that the experiments and the property tests wrote, and draws the page from them.

Nothing is measured here. tables reads and checks the rows, fitness says whether the paper may use them, statistics has the
arithmetic of everything that is published; a module a section makes of the rows what its template of the same name shows;
plots and drawings turn numbers into SVG; page puts the sections together. The paper,
README and the reference take their rows, words and numbers from the same modules, and the reference is drawn from templates, too.
"""
