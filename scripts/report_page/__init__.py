"""The page and the charts of experiments: from the folders of their runs to pictures, tables and one page."""
