# Sphinx: the pages of this directory and the interface of the Python module. Doxygen's pages of the C++ interface are
# copied to api/ beside them (cmake/documentation.cmake).
import os

import exsect

project = "exsect"
author = "The exsect authors"
copyright = author
version = release = exsect.__version__

extensions = ["myst_parser", "sphinx.ext.autodoc"]
exclude_patterns = ["examples", "schemas"]
nitpicky = False
myst_heading_anchors = 3
html_theme = "alabaster"
html_theme_options = {"page_width": "1100px", "sidebar_width": "240px", "fixed_sidebar": True}
html_extra_path = [os.environ["EXSECT_API_PAGES"]] if "EXSECT_API_PAGES" in os.environ else []
autodoc_member_order = "bysource"
autodoc_typehints = "description"
html_copy_source = False
