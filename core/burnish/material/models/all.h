// Every model of models.def, for what lists them.
#pragma once

#include <burnish/material/models/beckmann.h>
#include <burnish/material/models/ggx.h>
#include <burnish/material/models/kurt.h>
#include <burnish/material/models/sgd.h>
#include <burnish/material/models/ward.h>
