// Resolves every movie of a folder, in Fiji's script editor or without a display:
//   fiji --headless --run resolve_folder.groovy 'input="/data/in",out="/data/out"'
#@ File (label = "Folder of movies", style = "directory") input
#@ File (label = "Folder for the results", style = "directory") out
#@ CommandService commands

import io.github.knotresolver.command.ResolveFilamentCommand

input.listFiles().findAll { it.name.toLowerCase().endsWith(".tif") }.sort().each { movie ->
	def folder = new File(out, movie.name.replaceFirst(/\.[^.]*$/, ""))
	def module = commands.run(ResolveFilamentCommand, true,
		"movie", movie, "out", folder, "force", true, "overlay", false).get()
	def command = module.getDelegateObject()
	println(movie.name + ": " + (command.isCanceled()
		? command.getCancelReason()
		: module.getOutput("resolution").resolved() + " frames resolved"))
}
println("Results: " + out)
