# What ks_engine_describe is made of; core/engine/CMakeLists.txt includes this.
set(KS_DESCRIBE_SOURCES describe.cpp describe_events.cpp describe_states.cpp error_texts.cpp fact_text.cpp)
