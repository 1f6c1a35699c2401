// Texts of the list of systems, and what their steps did, in the user's language.
#ifndef oversketch_applications_studio_panels_system_strings_h
#define oversketch_applications_studio_panels_system_strings_h

#include "session.h"
#include "worker.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <string>
#include <vector>

namespace oversketch_studio
{

// A text of a row (Applications/Session/Scene/systems.cxx); translators find it under "Systems".
QString rowText(const std::string& text);
// Makes a sentence of it: it begins with a capital letter.
QString rowSentence(const std::string& text);
// The title of a step of a system.
QString titleOf(const std::string& system);
// The first step of a history, called so.
oversketch_session::Node firstNode(std::shared_ptr<const oversketch_session::Step> step);
// Texts of files that were read or written.
QStringList listOf(const std::vector<std::string>& texts);
// Its words in lines of so many characters at most, where none is longer.
QStringList wrapped(const QString& text, int most);

// Says what a step of the history did, in a few words for its row.
// `state`: null where the step has not been run.
QString wordsOf(const oversketch_session::Node& node, const oversketch_session::Worker::NodeState* state);

// Why a step cannot stand before another one.
QString whyNotBefore(const oversketch_session::Node& step, const oversketch_session::Node& needed);

} // namespace oversketch_studio
#endif
