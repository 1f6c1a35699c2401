// How a model was looked at as JSON: see README.md beside this.
#ifndef oversketch_applications_session_file_look_json_h
#define oversketch_applications_session_file_look_json_h

#include "json_reader.h"
#include "look.h"

namespace oversketch_session
{

Json::Value jsonOf(const Look& look);
// Throws oversketch_files::Failed where nothing could be seen so.
Look lookOf(const JsonReader& json);

} // namespace oversketch_session
#endif
