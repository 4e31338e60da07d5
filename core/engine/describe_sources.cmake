# What ks_engine_describe is made of; core/engine/CMakeLists.txt includes this.
set(KS_DESCRIBE_SOURCES describe.cpp describe_check.cpp describe_check_report.cpp describe_coach.cpp describe_events.cpp describe_states.cpp describe_error_texts.cpp describe_facts.cpp describe_fault.cpp
    describe_findings.cpp describe_flash.cpp describe_images.cpp describe_motionplan.cpp describe_parameter_file.cpp describe_parameters.cpp describe_smartdevice.cpp describe_stop.cpp)
