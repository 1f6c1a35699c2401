"""Contact sheets: many pictures of one size on few pages."""
import numpy as np

import picture


def write(pictures, stem, columns, rows):
    """Writes STEM-1.png, STEM-2.png, … with columns x rows pictures each, in reading order."""
    page = columns * rows
    for start in range(0, len(pictures), page):
        part = pictures[start:start + page]
        blank = np.ones_like(part[0])
        part = part + [blank] * (-len(part) % columns)
        lines = [np.concatenate(part[k:k + columns], axis=1) for k in range(0, len(part), columns)]
        picture.save(np.concatenate(lines[::-1], axis=0), f"{stem}-{start // page + 1}.png")
