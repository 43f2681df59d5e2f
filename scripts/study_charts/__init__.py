"""Charts and report of the intersection study: from the folders of its runs to pictures, sentences and one page."""
