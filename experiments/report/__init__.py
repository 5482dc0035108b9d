# SPDX-License-Identifier: GPL-3.0-or-later
"""The report: reads the tables that the experiments and the property tests wrote, and draws the page from them.

Nothing is measured here. tables reads and checks the rows, fitness says whether the paper may use them, statistics has the
arithmetic of everything that is published; a module a section makes of the rows what its template of the same name shows;
plots and drawings turn numbers into SVG; page puts the sections together. readme makes README's measured blocks, blocks puts what
is made of tables into README, and paper writes the paper's files, of paper_numbers and counterexamples in the words of formats. So
README and the paper take their numbers from the modules that the page is made of. So does the reference, which has templates, too.
"""
