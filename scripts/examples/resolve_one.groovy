// Resolves one movie and writes its result folder, in Fiji's script editor or without a display:
//   fiji --headless --run resolve_one.groovy 'movie="/data/movie.tif",out="/data/result"'
#@ File (label = "Movie") movie
#@ File (label = "Folder for the result", style = "directory") out
#@ CommandService commands

import io.github.knotresolver.command.ResolveFilamentCommand

def module = commands.run(ResolveFilamentCommand, true,
	"movie", movie, "out", out, "force", true).get()
def command = module.getDelegateObject()
if (!command.isCanceled())
	// One value a frame: a contour in pixels, fixed end first, where there is one.
	module.getOutput("resolution").frames().each { frame ->
		println(frame.frame() + " " + frame.status().label() + " " +
			frame.contour().map { it.length() + " px" }.orElse(frame.reason()))
	}
println(command.isCanceled() ? command.getCancelReason() : "Result: " + out)
