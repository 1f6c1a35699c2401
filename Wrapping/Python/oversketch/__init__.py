"""Oversketch: sketch-based mesh modelling as VTK filters.

Every class of the package is the VTK wrapper of the C++ class with the same name; see its help().
"""
from .OversketchFiltersSilhouette import *  # noqa: F401,F403
