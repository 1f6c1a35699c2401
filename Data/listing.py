"""The shipped strokes by the system that they are made for: one-stroke deformation, augmentation, edits, modelling from drawings over
pictures."""
import pathlib

STROKES = pathlib.Path(__file__).resolve().parent / "Strokes"
DRAWINGS = STROKES.parent / "Drawings"
ONE_STROKE = ("dinosaur_longer_tail", "dinosaur_raised_neck", "dog_curled_tail", "dog_longer_leg", "hand_bent_thumb", "hand_longer_finger",
              "octopus_bent_arm", "octopus_longer_arm", "person_longer_arm", "person_thicker_leg")
AUGMENT = ("dinosaur_spines", "dog_collar", "hand_palm_lines", "octopus_veins", "person_crest", "valley_river_ridge_road")
# What is done to the line of each edit [model length]; the dog's cross-section is drawn anew.
EDIT = {"dinosaur_crest": "move 0.5 n 0.17", "dog_back": "", "hand_palm": "move 0.5 n -0.1", "octopus_mantle": "move 0.5 n 0.07",
        "person_belly": "move 0.5 n 0.11"}
# The same with further ones that go with the lines and rings, so that each model has layers, painted weights and a cross-section.
FURTHER = {"dinosaur_crest_painted": "move 0.5 n 0.07", "dinosaur_crest_section": "", "dog_back_layers": "move 0.5 n 0.08",
           "dog_back_painted": "move 0.5 n 0.06", "hand_palm_layers": "move 0.5 n -0.1", "hand_palm_painted": "move 0.5 n 0.06",
           "hand_palm_section": "", "octopus_mantle_layers": "move 0.5 n 0.15", "octopus_mantle_section": "",
           "person_belly_painted": "move 0.5 n 0.035", "person_belly_section": ""}
INFLATE = ("figure_body", "figure_hat", "figure_head", "fish", "heron", "leaf", "mug", "padlock")


def one_stroke():
    """The files of the strokes that deform, by name."""
    return [STROKES / f"{name}.vtp" for name in ONE_STROKE]


def augment():
    """The files of the strokes that augment, by name."""
    return [STROKES / f"{name}.vtp" for name in AUGMENT]


def edits():
    """The files of the lines that edits are made with, by name; the ring round each is beside it, NAME_ring, and in Data/Edits what goes with
    it: layers NAME.json, painted weights NAME.png, a cross-section NAME_profile.vtp."""
    return [STROKES / f"{name}.vtp" for name in EDIT]


def drawings():
    """The files of the drawings, by name; each has its picture beside it, of the same name."""
    return [DRAWINGS / f"{name}.vtp" for name in INFLATE]
