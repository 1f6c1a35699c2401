"""Whatever the Studio says can be translated: no sentence in its sources stands outside tr()."""
import os
import pathlib
import re

STUDIO = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Applications" / "Studio"
STRING = r'"(?:[^"\\\n]|\\.)*"'
TRANSLATED = re.compile(r"(?:\btr\(|\btranslate\(\s*%s,|QT_TRANSLATE_NOOP\(\s*%s,)\s*%s(?:\s*%s)*" % ((STRING,) * 4))
# What no person reads, or a terminal shows.
NOT_READ = re.compile(r'setObjectName\(%s\)|fprintf\([^;]*;|#include[^\n]*|(?:create|toString|startsWith|shippedFile)\(%s\)|\{ %s, (?=QT_TR)|[!=]= %s|const char\* const \w+ = %s|translate\(%s, (?!")|R"\(.*?\)"'
                      r'|(?:change\(|findParameter\(\*\w+, |findSystem\(|HeldStrokeTool\(|\.find\(|values\[|valueOr\(values, |GetInnerOutput\(|GetArray\()%s'
                      r'|\{ %s, this->|options\.\w+\(%s|length : \{ %s, %s|\{ "\^(?:[^"\\\n]|\\.)*"' % ((STRING,) * 11), re.S)
SENTENCE = re.compile(r"[A-Za-z]{2,}[,.:]? [A-Za-z]|^\"[A-Z][a-z]+\"$")


def untranslated(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = TRANSLATED.sub("", NOT_READ.sub("", text))
    return [string for string in re.findall(STRING, text) if SENTENCE.search(string)]


def test_no_sentence_is_fixed():
    sources = [path for path in [*STUDIO.glob("*.cxx"), *STUDIO.glob("Tools/*.cxx")] if path.stem != "latency"]
    assert len(sources) > 5
    assert {path.name: untranslated(path.read_text()) for path in sources if untranslated(path.read_text())} == {}


def test_a_fixed_sentence_is_found():
    assert untranslated('box.setText("All is lost.");') == ['"All is lost."']
    assert untranslated('box.setText(tr("All is " "lost."));') == []
    assert untranslated('add(menu, "Save", {});') == ['"Save"']
