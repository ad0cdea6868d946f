"""The built site on paper: two PDFs and an EPUB in `_build` (`make paper`).

`pages.js` takes the pages of `_build/html` and makes of each what can stand still; `pages.py` asks
it. `pdf.py` prints them as one document, and the contents in front of it; `epub.py` packs them.
"""
