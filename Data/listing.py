"""The shipped strokes by the system that they are made for: those of one-stroke deformation and those of augmentation."""
import pathlib

STROKES = pathlib.Path(__file__).resolve().parent / "Strokes"
ONE_STROKE = ("dinosaur_longer_tail", "dinosaur_raised_neck", "dog_curled_tail", "dog_longer_leg", "hand_bent_thumb", "hand_longer_finger",
              "octopus_bent_arm", "octopus_longer_arm", "person_longer_arm", "person_thicker_leg")
AUGMENT = ("dinosaur_spines", "dog_collar", "hand_palm_lines", "octopus_veins", "person_crest", "valley_river_ridge_road")


def one_stroke():
    """The files of the strokes that deform, by name."""
    return [STROKES / f"{name}.vtp" for name in ONE_STROKE]


def augment():
    """The files of the strokes that augment, by name."""
    return [STROKES / f"{name}.vtp" for name in AUGMENT]
