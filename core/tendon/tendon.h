#pragma once

/// Includes everything that the author of a component needs: tasks, functions and events, state
/// tables, payloads, and the manager that connects components of one process. It does not include
/// headers for the network.

#include <tendon/base/log.h>
#include <tendon/interface/event.h>
#include <tendon/interface/event_waiter.h>
#include <tendon/interface/function.h>
#include <tendon/interface/status_messages.h>
#include <tendon/manager/component_registry.h>
#include <tendon/manager/local_manager.h>
#include <tendon/payload/json.h>
#include <tendon/payload/payload.h>
#include <tendon/state/filter.h>
#include <tendon/state/state_table.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/continuous_task.h>
#include <tendon/task/main_task.h>
#include <tendon/task/periodic_task.h>
#include <tendon/task/signal_task.h>
