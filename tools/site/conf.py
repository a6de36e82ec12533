"""How Sphinx makes the site of the pages that stage.py has laid out. No page asks the network."""

project = "ASV brooms"
author = "the authors of ASV brooms"
copyright = author
extensions = ["myst_parser", "breathe"]
root_doc = "index"
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}

# The pages are written for readers of the repository: HTML images, links to headings.
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 4
# Some pages begin their headings at the third level, as a part of a table of contents.
suppress_warnings = ["myst.header"]

breathe_default_project = "asv"
breathe_default_members = ("members",)
breathe_show_include = False

highlight_language = "text"
html_theme = "furo"
html_title = "ASV brooms"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
    "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"},
}
