"""Documents as files: LaTeX and PDF, Markdown, HTML with MathML."""
