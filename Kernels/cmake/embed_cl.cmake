# cmake -D input=FILE.cl -D output=FILE_cl.h -D name=FILE_cl -P embed_cl.cmake
file(READ "${input}" text)
file(WRITE "${output}" "// Made from ${name}; not to be edited.\n#pragma once\nnamespace oversketch\n{\ninline constexpr char ${name}[] = R\"opencl(\n${text})opencl\";\n}\n")
