"""The built site on paper: two PDFs in `_build` (`make paper`).

`pages.js` takes the pages of `_build/html` and leaves of each what can be printed; `pages.py` asks
it. `pdf.py` prints them as one document, and the contents in front of it.
"""
