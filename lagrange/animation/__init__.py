"""A motion that can be played on a web page: its equations, its figure and its values as data and JavaScript."""
