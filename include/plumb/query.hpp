// The face of questions about two figures: everything in plumb/query/.
#pragma once
