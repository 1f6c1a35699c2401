// What a step of the history did, in a few words for its row.
#ifndef oversketch_applications_studio_panels_step_summary_h
#define oversketch_applications_studio_panels_step_summary_h

#include "session.h"
#include "worker.h"

#include <QString>

namespace oversketch_studio
{

// `state`: null where the step has not been run.
QString wordsOf(const oversketch_session::Node& node, const oversketch_session::Worker::NodeState* state);

// Why a step cannot stand before another one.
QString whyNotBefore(const oversketch_session::Node& step, const oversketch_session::Node& needed);

} // namespace oversketch_studio
#endif
