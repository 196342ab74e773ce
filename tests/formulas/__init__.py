"""Read the formulas of documents, from LaTeX and from MathML, and evaluate them.

`latex` and `mathml` give what stands on the page, `tree` what it says, `values` what it is worth.
Both readers go by what a person sees: braces and rows without a sign of their own hold nothing
together.
"""
